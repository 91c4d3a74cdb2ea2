// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/body/body_sequence.h"

#include <deal.II/lac/vector.h>

namespace frictionbeam {

/**
 * Squared residual error estimate of each owned active cell [J], others 0: with p the degree and
 * h the size,
 *   eta^2 = 1/E [ (h/p)^2 |div sigma|^2 + h/(2p) |[sigma n]|^2 (between cells)
 *               + h/p |sigma n - t|^2 (boundary, components that are not held) ],
 * t the load's traction, or that of friction as its nodes have it (doc/continuum.md, "Refinement").
 */
template <int dim>
dealii::Vector<float> estimate_error(const ContinuumBody<dim> &body, const ContinuumState &state,
                                     const ContinuumVector &contact_traction);

/**
 * Refine the cells that hold @p fraction of the squared estimate, and those at ends of slipping or
 * open zones twice (unless @p fraction is 1: all cells), and carry @p guess over. The same cells
 * whatever the number of processes.
 * @return the share of the squared estimate in cells of the first mesh that are left as they are
 */
template <int dim>
double refine(ContinuumBody<dim> &body, const dealii::Vector<float> &estimate,
              const double fraction, const ContinuumState &state, ContinuumGuess &guess);

} // namespace frictionbeam
