// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/statics.h"
#include "analysis/substructure/pressed_parts.h"

namespace frictionbeam {

/// Static increments of a line on which nothing but contact is nonlinear: each is solved by the
/// method of Solver/Method, which knows the stiffness from the start; where pressure stiffens solid
/// parts, it is made anew for the stiffness at the end of each increment that changes a pressure.
class LinearStatics : public Statics {
public:
  explicit LinearStatics(const Model &model);

  EquilibriumResult solve(const LineState &from, const StaticIncrement &increment, LineState &to,
                          ContactResponse &response) override;
  EnergyAccount account(const LineState &before, const LineState &after, const LoadCourse &course,
                        const Vector &unbalanced) const override;
  Vector forces_on_contacts(const LineState &state, const LoadCourse &course) const override;
  std::vector<contact::BeyondUniqueness>
  beyond_uniqueness(const std::vector<ContactStatus> &status) const override {
    return method().beyond_uniqueness(status);
  }
  void hold_less() override;
  void transfer(Archive &archive) override { archive(method()); }

private:
  std::unique_ptr<EquilibriumSolver> make_method() const;
  EquilibriumSolver &method() const;
  /// Without contacts, at the pressures that there are.
  const SparseMatrix &stiffness() const {
    return stiffened ? *stiffened : model.linear.stiffness();
  }
  /// Take the stiffness at the end of an increment. @return why it has no stable answer, if so
  std::optional<EquilibriumResult> stiffen(const std::vector<double> &factors);
  /// Put away the method, and what solutions to come depend on.
  void put_method_away();

  const Model &model;
  const PressedParts parts;
  std::vector<double> pressures; ///< in the parts, of the stiffness
  std::optional<SparseMatrix> stiffened;
  mutable std::unique_ptr<EquilibriumSolver> solver; ///< null: put away
  mutable std::string put_away;                      ///< what solutions to come depend on
};

} // namespace frictionbeam
