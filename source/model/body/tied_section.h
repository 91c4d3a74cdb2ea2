// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/body.h"

namespace frictionbeam {

/// A cross-section of a pipe whose motion is held in some directions, and that is free otherwise:
/// it may widen and become oval.
struct TiedSection {
  dealii::Point<3> centre;
  dealii::Tensor<1, 3> normal; ///< unit
  double radius = 0.;          ///< outer [m]
  std::vector<Motion> held;    ///< directions h, of which h . motion = 0
};

/**
 * Hold the motion of cross-sections, besides what the body's constraints hold already. Of the
 * displacement u on a section of area A, with arms r from its middle and the normal t, displacement
 * and rotation are
 *   integral u / A  and  integral (t.u r x t / I + (r x u).t t / (2 I)),  I = integral r^2 / 2,
 * so that what holds it is a traction that is uniform, or linear in the distance from the middle.
 * One unknown for each direction, inside of the outer surface, becomes a sum of the section's
 * others.
 */
void tie_sections(const std::vector<TiedSection> &sections, ContinuumBody<3> &body);

} // namespace frictionbeam
