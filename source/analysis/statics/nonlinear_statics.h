// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/linearized_solver.h"
#include "analysis/statics/statics.h"

namespace frictionbeam {

/**
 * Static increments of any cells: Newton's method on the line, in each of whose iterations the
 * contacts are solved on the linearized line. It has converged when the forces of the line itself
 * balance those of the contacts, which obey their laws at that very pose.
 */
class NonlinearStatics final : public Statics {
public:
  explicit NonlinearStatics(const Model &model) : model(model), linearized(model) {}

  EquilibriumResult solve(const LineState &from, const StaticIncrement &increment, LineState &to,
                          ContactResponse &response) override;
  /// Stored energy exactly, work by the forces halfway, so that what is left over measures the
  /// increment.
  EnergyAccount account(const LineState &before, const LineState &after, const LoadCourse &course,
                        const Vector &unbalanced) const override;
  Vector forces_on_contacts(const LineState &state, const LoadCourse &course) const override;
  /// Nothing is proved of large motions.
  std::vector<BeyondUniqueness>
  beyond_uniqueness(const std::vector<ContactStatus> &) const override {
    return {};
  }
  void transfer(Archive &) override {} // every increment begins anew

private:
  const Model &model;
  LinearizedSolver linearized;
};

} // namespace frictionbeam
