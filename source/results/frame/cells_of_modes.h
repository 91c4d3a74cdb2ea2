// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"

namespace frictionbeam {

/**
 * By what part the frequency of a mode is off, as its cells are long against its waves.
 *
 * In a wave of wave number b, b^4 = w^2 m/(EI), the cubic shapes of a cell of length l and its
 * consistent mass have w^2 too high by (b l)^4/720, in one along the axis, k^2 = w^2 m/(EA), by
 * (k l)^2/12, to leading order (T. J. R. Hughes, The Finite Element Method, 1987, 7.3). Here each
 * cell counts with its part of the kinetic energy. Lumped mass has that of the cells' ends: what
 * it is more than that of the shapes lowers w^2, by (k l)^2/6 along the axis.
 *
 * @param motion of all degrees of freedom, of modal mass 1 kg m2
 * @param angular_frequency w [1/s]
 */
double frequency_error_of_cells(const Model &model, const Vector &motion,
                                const double angular_frequency);

} // namespace frictionbeam
