// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/elastic_system.h"

namespace frictionbeam {

using namespace dealii;

namespace {

/// Unknowns from which multigrid pays in 3D, and those of linear elements on the first mesh up to
/// which it does, by themselves or as a part of all: each of Newton's steps factors these.
constexpr types::global_dof_index least_multigrid = 3000, most_coarsest = 3000;
constexpr unsigned int least_coarsening = 4;
template <int dim>
constexpr types::global_dof_index most_direct = dim == 2 ? 60000 : 15000;

/// Whether the mesh hierarchy is one that multigrid was made for.
template <int dim>
bool suits_multigrid(const ContinuumBody<dim> &body) {
  const types::global_dof_index n = body.dof_handler.n_dofs(),
                                coarsest = dim * body.mesh.vertices.size();
  return dim == 3 && n >= least_multigrid &&
         (coarsest <= most_coarsest || coarsest <= n / least_coarsening) &&
         body.mesh.manifolds.empty() && body.continuum.sections.empty();
}

} // namespace

template <int dim>
std::unique_ptr<ContinuumSystem> make_continuum_system(const ContinuumBody<dim> &body) {
  using LinearSolver = ContinuumSettings::LinearSolver;
  const LinearSolver wish = body.scene.continuum_settings.linear_solver;
  if (wish == LinearSolver::multigrid || (wish == LinearSolver::automatic && suits_multigrid(body)))
    return make_multigrid_system(body);
  if (!body.is_parallel)
    return make_condensed_system(body);
  return make_distributed_system(
      body, wish == LinearSolver::direct ||
                (wish == LinearSolver::automatic && body.dof_handler.n_dofs() <= most_direct<dim>));
}

template std::unique_ptr<ContinuumSystem> make_continuum_system<2>(const ContinuumBody<2> &);
template std::unique_ptr<ContinuumSystem> make_continuum_system<3>(const ContinuumBody<3> &);

} // namespace frictionbeam
