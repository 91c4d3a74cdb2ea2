// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/collapse.h"
#include "base/archive.h"

#include <optional>
#include <vector>

namespace frictionbeam {

/**
 * Motions of a line that may be those of the mechanism it gives way by: of the last increment that
 * was solved, of the last that was not, and where its tangent is softest.
 */
class LastMotions {
public:
  explicit LastMotions(const Model &model) : model(model) {}

  /// An increment is solved.
  /// @param moved unknowns @param tangent at its end
  void add_solved(const Vector &moved, const SparseMatrix &tangent);
  /// An increment has failed.
  /// @param forces left at its last pose, but for the contacts
  /// @param gain loads on the unknowns that were to come
  void add_failure(const Vector &moved, const SparseMatrix &tangent, const Vector &forces,
                   const Vector &gain);
  /// The mechanism of the least bound among them (find_collapse()), improved on lines without
  /// contacts by hinges that form on its way.
  std::optional<Collapse> collapse(const LineState &at, const std::vector<double> &begin,
                                   const std::vector<double> &end) const;
  void transfer(Archive &archive);

private:
  /// Of a line whose sections flow as they do where a motion from a state turns a vertex so far:
  /// it knows hinges that form on the way; empty where they have no answer.
  Vector softer_motion(const LineState &at, const Vector &motion, const double turn,
                       const std::vector<double> &factors, const Vector &forces) const;
  Vector loads_on_unknowns(const LineState &at, const std::vector<double> &factors) const;
  /// By forces, of a line that is a little stiffer than a mechanism; empty where there is none.
  Vector soft_motion(SparseMatrix tangent, const Vector &forces) const;

  const Model &model;
  /// Of all degrees of freedom, without what was imposed: of the last increment that was solved, of
  /// the last that was not, where its tangent is softest, and where that of the state before is.
  Vector solved, failed, softest_at_failure, softest_before;
  SparseMatrix last_tangent; ///< of the last increment that was solved
};

/// Of a vertex, among changes of all degrees of freedom [rad].
double largest_turn(const Discretization &discretization, const Vector &dofs);

} // namespace frictionbeam
