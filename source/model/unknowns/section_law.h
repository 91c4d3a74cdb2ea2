// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/profile.h"

namespace frictionbeam {

/**
 * The section's law with all its parameters: those of the file, and of those that it left out, by
 * their names, what section, material and bend know: Young's modulus, Poisson ratio, Outside
 * diameter, Wall thickness, Bend radius, and the rigidities of @p profile (axial, shear,
 * torsional, bending).
 * @throws UserError if a law needs a diameter and the section has none, or if it knows nothing of
 * bends and stands in one that is more flexible than a straight pipe.
 */
BoundLaw bind_section_law(const LawDescription &law, const Section &section, const Profile &profile,
                          const double bend_radius, const std::string &pipe);

/// Its elastic tangent, 6 x 6.
dealii::Table<2, double> elastic_tangent(const BoundLaw &law);

} // namespace frictionbeam
