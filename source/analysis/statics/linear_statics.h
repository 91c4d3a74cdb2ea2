// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/statics.h"

namespace frictionbeam {

/// Static increments of a line on which nothing but contact is nonlinear: each is solved by the
/// method of Solver/Method, which knows the stiffness from the start.
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
    return solver->beyond_uniqueness(status);
  }
  void transfer(Archive &archive) override { archive(*solver); }

private:
  const Model &model;
  const std::unique_ptr<EquilibriumSolver> solver;
};

} // namespace frictionbeam
