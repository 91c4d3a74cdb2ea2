// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_pose.h"
#include "model/model.h"

#include <optional>
#include <string>

namespace frictionbeam {

/// What may stay open between the loads that are carried and their bound, and it is proved.
constexpr double open_by_proof = 1e-6;

/// How a line whose pipes yield gives way under loads that go from one state to another.
struct Collapse {
  /// No more than this part of the way is carried by any state of stress (upper bound theorem), or
  /// infinity.
  double bound;
  std::string mechanism; ///< where it yields and slips, in plain words
};

/**
 * The last motion of a line before it found no equilibrium any more, taken for a mechanism: loads
 * P_0 + c (P_1 - P_0) do more work on it than the pipes can dissipate from
 *   c = (D - P_0 . du) / ((P_1 - P_0) . du)
 * on, D what their cells dissipate at the utmost on it, and what contacts do at their present
 * forces. D is without bound where a section hardens.
 *
 * @param motion of all degrees of freedom @param begin, end factors of the loads
 * @return nothing where that motion does not gain from the loads
 */
std::optional<Collapse> find_collapse(const Model &model, const LineState &at, const Vector &motion,
                                      const std::vector<double> &begin,
                                      const std::vector<double> &end);

} // namespace frictionbeam
