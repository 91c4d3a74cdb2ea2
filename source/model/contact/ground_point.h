// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/contact/contact.h"

namespace frictionbeam {

/**
 * What of the way from a support's point to the point it stands on is across its normal [m]: the
 * arm by which the ground's pipe reaches under the support.
 */
Vector3 arm_of_ground(const Discretization &discretization, const Contact &contact);

/**
 * Degrees of freedom and strains of a contact between two points of pipes. The friction element has
 * the axis and the length of the support, wherever its two nodes are: with u_2 = u_G + theta_G x a,
 * a the arm of the ground, which is rigid, from G to the element's end P + l x,
 *   eps = x.(u_2 - u_P)/l, gamma_y = y.(u_2 - u_P)/l - psi_z, gamma_z = z.(u_2 - u_P)/l + psi_y,
 * psi as the support's Rotations say. A ground without rotations has no arm: what of it is along
 * the normal is then an arm of the support's pipe. With Rotations = none there is none along it.
 */
void stand_on_point(const FrictionSupport &support, const Discretization &discretization,
                    Contact &contact);

} // namespace frictionbeam
