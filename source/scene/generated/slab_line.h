// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include "scene/scene.h"

namespace frictionbeam::generated {

/**
 * What the line model of the slab takes over from the continuum, if asked to.
 *
 * - Axial stiffness: E, or E/(1 - nu^2) in plane strain.
 * - Poisson squeeze: the free axial strain under the pressure p, nu p/E (plane stress), nu (1+nu)
 *   p/E (plane strain). Friction resists it and is left in compression. It is a thermal strain like
 *   any other line's: for one, take Expansion times Temperature as large.
 * - Shear lag: the surface moves less than the mean of the section. A shear traction t on a surface
 *   at the height H above frictionless rollers, distributed linearly over the height, gives a
 *   difference of t H/(3 G), that is an interface of stiffness k = c G b/H per unit length with
 *   c = 3, in series with the friction elements.
 */
struct SlabLine {
  double axial_modulus = 0.;  ///< [Pa]
  double squeeze = 0.;        ///< free axial strain [-]
  double shear_rigidity = 0.; ///< GS of a friction element, 1 m long [N]; 0: rigid
};

void declare_slab_line(ParameterReader &in);

/// @p spacing of the friction elements [m].
SlabLine read_slab_line(const ParameterReader &in, const double spacing);

/// Compressive forces N_2, N_4, N_6 at x = 2, 4, 6 where there are nodes, the mean of the values
/// on either side, and u_0_mean: the quantities of the continuum.
std::vector<Quantity> slab_line_quantities(const double length, const unsigned int n_elements);

} // namespace frictionbeam::generated
