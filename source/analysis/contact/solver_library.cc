// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/solver_library.h"

#include "analysis/contact/exact_solver.h"
#include "analysis/contact/return_mapping_solver.h"

namespace frictionbeam {

std::unique_ptr<EquilibriumSolver> make_equilibrium_solver(const SolverSettings &settings,
                                                           const SolverSettings::Method method,
                                                           const Contacts &contacts,
                                                           const ReducedSpace &space,
                                                           const SparseMatrix &stiffness) {
  if (method == SolverSettings::Method::exact)
    return std::make_unique<ExactSolver>(settings, contacts, space, stiffness);
  return std::make_unique<ReturnMappingSolver>(settings, method, contacts, space);
}

} // namespace frictionbeam
