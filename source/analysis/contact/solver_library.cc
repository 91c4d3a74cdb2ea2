// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/solver_library.h"

#include "analysis/contact/exact_method.h"
#include "analysis/contact/return_mapping_solver.h"

#include <iterator>

namespace frictionbeam {

namespace {

using Solver = std::unique_ptr<EquilibriumSolver>;

Solver return_mapping(const SolverSettings &settings, const Contacts &contacts,
                      const ReducedSpace &space, const SparseMatrix &, contact::PartMemory *) {
  return std::make_unique<ReturnMappingSolver>(settings, contacts, space);
}

Solver exact(const SolverSettings &settings, const Contacts &contacts, const ReducedSpace &,
             const SparseMatrix &stiffness, contact::PartMemory *const memory) {
  return std::make_unique<ExactMethod>(settings, contacts, stiffness, memory);
}

/// What makes the solver of a method, whose word and meaning stand in `solver_methods`.
struct Maker {
  SolverMethod value;
  Solver (*make)(const SolverSettings &, const Contacts &, const ReducedSpace &,
                 const SparseMatrix &, contact::PartMemory *);
};

constexpr Maker makers[] = {{SolverMethod::elastic, &return_mapping},
                            {SolverMethod::newton, &return_mapping},
                            {SolverMethod::exact, &exact}};

static_assert(std::size(makers) == std::size(solver_methods), "each method is made by one row");

} // namespace

std::unique_ptr<EquilibriumSolver> make_equilibrium_solver(const SolverSettings &settings,
                                                           const Contacts &contacts,
                                                           const ReducedSpace &space,
                                                           const SparseMatrix &stiffness,
                                                           contact::PartMemory *const memory) {
  return row_of(makers, settings.method).make(settings, contacts, space, stiffness, memory);
}

} // namespace frictionbeam
