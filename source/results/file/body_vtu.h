// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/body/body_sequence.h"

#include <deal.II/numerics/data_postprocessor.h>

namespace frictionbeam {

/// What a body's stress in a state is computed by from the gradient of its displacement.
template <int dim>
using StressOf =
    std::function<std::unique_ptr<dealii::DataPostprocessor<dim>>(const ContinuumState &)>;

/// Stress without free strain: xx, yy, xy (zz, yz, zx).
template <int dim>
std::unique_ptr<dealii::DataPostprocessor<dim>> stress_of_body(const ContinuumBody<dim> &body);

/// `NAME_STEP.vtu` (with mpirun `NAME_STEP.pvtu` and its pieces) of each step's end, with
/// `NAME.pvd`: displacement, stress, and traction where the body has contacts. By all processes.
template <int dim>
void write_body_vtu(const ContinuumBody<dim> &body, const std::vector<ContinuumState> &states,
                    const std::string &name, const StressOf<dim> &stress_of,
                    const std::string &folder);

} // namespace frictionbeam
