// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/equilibrium.h"

namespace frictionbeam {

/// The solver that Solver/Method names. @p stiffness of the line, without contacts. @p memory of
/// its parts, where such matrices come one after the other.
std::unique_ptr<EquilibriumSolver> make_equilibrium_solver(const SolverSettings &settings,
                                                           const Contacts &contacts,
                                                           const ReducedSpace &space,
                                                           const SparseMatrix &stiffness,
                                                           contact::PartMemory *memory = nullptr);

} // namespace frictionbeam
