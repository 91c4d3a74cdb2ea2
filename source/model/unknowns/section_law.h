// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/profile.h"

namespace frictionbeam {

/**
 * The section's law with all its parameters: those of the file, and of those that it left out, by
 * their names, what section, material and bend know: Young's modulus, Poisson ratio, Outside
 * diameter, Wall thickness, Bend radius, Bend length, Place in bend (the middle of the cell), the
 * rigidities of @p profile (axial, shear, torsional, bending), Height and Width of the rectangle
 * with its area and inertia. A law that has `Bend radius` and no `Bending rigidity` has the
 * flexibility of bends in itself.
 * @throws UserError if a law needs a diameter and the section has none, or the other way round, if
 * it knows nothing of bends and stands in one that is more flexible than a straight pipe, or if it
 * has their flexibility in itself and does not know the bend, or another flexibility is given.
 */
BoundLaw bind_section_law(const LawDescription &law, const Pipe &pipe, const Section &section,
                          const BendPart &bend, const Profile &profile);

/// The law of a profile at a part of the way along its cell, in the direction of the pipe.
BoundLaw law_at(const Profile &profile, const double part);

/// Its elastic tangent, 6 x 6, at a temperature [degC].
dealii::Table<2, double> elastic_tangent(const BoundLaw &law,
                                         const double temperature = LawIncrement().temperature);

/// Gives a profile a law that yields or creeps, and the rigidities of that law's elastic tangent;
/// of a law that has the flexibility of bends in itself, in the mean of the cell.
/// @throws UserError if it bends differently about its two axes in an arc.
void take_section_law(const BoundLaw &law, const Pipe &pipe, const Section &section,
                      const BendPart &bend, Profile &profile);

} // namespace frictionbeam
