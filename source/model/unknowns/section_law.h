// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/profile.h"

namespace frictionbeam {

/**
 * The section's law with all its parameters: those of the file, and of those that it left out, by
 * their names, what section, material and bend know: Young's modulus, Poisson ratio, Outside
 * diameter, Wall thickness, Bend radius, Bend length, Place in bend (the middle of the cell), and
 * the rigidities of @p profile (axial, shear, torsional, bending). Of a law with the flexibility of
 * bends in itself (that has `Bend radius` and no `Bending rigidity`), profile.EI gets what its
 * elastic tangent has in the mean of the cell, so that no factor of a code counts besides.
 * @throws UserError if a law needs a diameter and the section has none, if it knows nothing of
 * bends and stands in one that is more flexible than a straight pipe, or if it has the flexibility
 * of bends in itself, and the bend is none that it knows or has been given another.
 */
BoundLaw bind_section_law(const LawDescription &law, const Section &section, const Pipe &pipe,
                          const BendPart &bend, Profile &profile);

/// The law at a part of the way along a cell.
BoundLaw law_at(const Profile &profile, const double part);

/// Its elastic tangent, 6 x 6.
dealii::Table<2, double> elastic_tangent(const BoundLaw &law);

} // namespace frictionbeam
