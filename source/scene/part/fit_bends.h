// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/// What two bends take from the leg between them, more than it has.
struct BendOverlap {
  unsigned int leg; ///< from the route's point of this number to the next
  double overlap;   ///< [m], before anything was changed
};

/// Length that the bend at a corner takes from either of its legs, R tan(angle/2) [m]; 0 for a
/// sharp corner and for the ends. The route must not turn back there.
double tangent_length(const std::vector<RoutePoint> &route, const unsigned int corner);

/**
 * Make bends meet that overlap by no more than the rounding of a drawing's dimensions explains:
 * elbows back to back, an elbow at a flange.
 *
 * On a leg of length L between bends that take c_1 and c_2 of it, the overlap c_1 + c_2 - L may be
 * largest_overlap() at most. The tangent lengths are changed so that they fill the leg, with the
 * least sum of (change of c)^2/c: of a single leg, both in proportion. The corners stay, the radii
 * follow.
 *
 * @return the legs where that was needed, in order; @p too_long is the first leg whose overlap is
 * larger, and then nothing is changed.
 */
std::vector<BendOverlap> fit_bends(std::vector<RoutePoint> &route,
                                   std::optional<BendOverlap> &too_long);

/// 2 mm, as coordinates and a radius to the millimetre make it, but no more than 1 % of the leg.
double largest_overlap(const double leg);

} // namespace frictionbeam
