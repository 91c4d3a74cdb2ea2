// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

namespace frictionbeam {

/**
 * What the mesh of a bend's wall leaves of its flexibility: cells that are long beside sqrt(r t)
 * around the circumference are too stiff, by a part of c eta^p, eta = (2 pi r/n)^2/(r t) of n
 * cells; degree 2: 0.044 eta^1.6, degree 3: 0.001 eta^1.9. Measured on bends of 90 degrees with R =
 * 3 r and r/t from 6 to 60 against 48 (degree 2) and 32 cells (degree 3), within a factor of 1.5
 * where that is 0.2 to 35 % (doc/solid.md).
 * @return none for cells of degree 1, which lock
 */
std::optional<double> flexibility_error(const unsigned int degree, const unsigned int n_around,
                                        const double r_over_t);

/// The fewest cells of degree 3 around a wall, in fours, that leave no more than an error.
unsigned int cells_around_for(const double error, const double r_over_t);

} // namespace frictionbeam
