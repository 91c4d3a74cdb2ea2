// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/elastic_multigrid.h"

#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include <set>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Free nodes of linear elements on surfaces with friction, of this process.
template <int dim>
std::vector<std::array<types::global_dof_index, dim>>
contact_vertices(const ContinuumBody<dim> &body, const DoFHandler<dim> &dof_handler,
                 const AffineConstraints<double> &constraints) {
  std::set<std::array<types::global_dof_index, dim>> found;
  const IndexSet &owned = dof_handler.locally_owned_dofs();
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (!cell->is_artificial() && cell->at_boundary())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && body.surface_of(face->boundary_id()) >= 0)
          for (const unsigned int v : face->vertex_indices()) {
            std::array<types::global_dof_index, dim> dofs;
            bool is_free = false;
            for (unsigned int d = 0; d < dim; ++d) {
              dofs[d] = face->vertex_dof_index(v, d);
              is_free = is_free || !constraints.is_constrained(dofs[d]);
            }
            if (is_free && owned.is_element(dofs[0]))
              found.insert(dofs);
          }
  return {found.begin(), found.end()};
}

/// All meshes from the first to this one, each the one above with all its cells coarsened.
template <int dim>
std::vector<std::shared_ptr<const Triangulation<dim>>> coarsened(const Triangulation<dim> &finest,
                                                                 const bool is_parallel) {
  if (is_parallel)
    return MGTransferGlobalCoarseningTools::create_geometric_coarsening_sequence(finest);
  std::vector<std::shared_ptr<const Triangulation<dim>>> meshes = {
      std::shared_ptr<const Triangulation<dim>>(&finest, [](const auto *) {})};
  while (meshes.front()->n_levels() > 1) {
    auto coarser = std::make_shared<Triangulation<dim>>();
    coarser->copy_triangulation(*meshes.front());
    coarser->coarsen_global();
    meshes.insert(meshes.begin(), coarser);
  }
  return meshes;
}

} // namespace

template <int dim>
ElasticMultigrid<dim>::ElasticMultigrid(const ContinuumBody<dim> &body)
    : meshes(coarsened(*body.triangulation, body.is_parallel)) {
  const bool has_linear_twin = body.fe.degree > 1;
  levels.resize(meshes.size() + has_linear_twin);
  for (unsigned int l = 0; l < levels.size(); ++l) {
    Level &level = levels[l];
    const bool is_finest = l + 1 == levels.size();
    if (is_finest)
      level.dof_handler = &body.dof_handler;
    else {
      // The finest mesh is the body's own one, whose cells are where its elements are.
      const bool is_twin = l + 1 == meshes.size();
      level.linear = std::make_unique<const FESystem<dim>>(FE_Q<dim>(1), dim);
      level.own_numbering = std::make_unique<DoFHandler<dim>>(
          is_twin ? static_cast<const Triangulation<dim> &>(*body.triangulation) : *meshes[l]);
      level.own_numbering->distribute_dofs(*level.linear);
      level.dof_handler = level.own_numbering.get();
    }
    set_up(level, body, is_finest);
    if (l == 0)
      continue;
    const Level &below = levels[l - 1];
    level.transfer.reinit({*level.dof_handler, *level.constraints},
                          {*below.dof_handler, *below.constraints}, is_finest && has_linear_twin,
                          body.is_parallel);
  }
  coarsest = std::make_unique<CoarseFactorization<dim>>(body, *levels[0].dof_handler,
                                                        *levels[0].constraints);
}

template <int dim>
void ElasticMultigrid<dim>::set_up(Level &level, const ContinuumBody<dim> &body,
                                   const bool is_finest) {
  if (is_finest) {
    level.constraints = &body.constraints;
    for (const auto &node : body.nodes)
      level.contacts.push_back(node.dofs);
  } else {
    level.own_constraints = std::make_unique<AffineConstraints<double>>();
    body.constrain(*level.dof_handler, *level.own_constraints);
    level.constraints = level.own_constraints.get();
    level.contacts = contact_vertices(body, *level.dof_handler, *level.constraints);
  }
  level.stiffness =
      std::make_unique<ElasticOperator<dim, float>>(body, *level.dof_handler, *level.constraints);
  for (auto *const vector : {&level.x, &level.b, &level.residual})
    level.stiffness->reinit(*vector);
  if (&level != &levels[0])
    level.smoother = std::make_unique<ChebyshevSmoother<dim>>(*level.stiffness);
}

template <int dim>
std::vector<NodeBlock<dim>> ElasticMultigrid<dim>::restricted(const Level &level,
                                                              const Level &below) const {
  std::vector<NodeBlock<dim>> result(below.contacts.size());
  for (unsigned int c = 0; c < dim; ++c) {
    level.b = 0.f;
    below.b = 0.f;
    for (const NodeBlock<dim> &block : level.stiffness->node_blocks())
      for (unsigned int a = 0; a < dim; ++a)
        level.b(block.dofs[a]) = block.stiffness(a, c);
    level.transfer.restrict_and_add(below.b, level.b);
    for (std::size_t i = 0; i < result.size(); ++i)
      for (unsigned int a = 0; a < dim; ++a) {
        result[i].dofs = below.contacts[i];
        const bool is_free = !below.constraints->is_constrained(below.contacts[i][a]) &&
                             !below.constraints->is_constrained(below.contacts[i][c]);
        result[i].stiffness(a, c) = is_free ? below.b(below.contacts[i][a]) : 0.;
      }
  }
  for (NodeBlock<dim> &block : result)
    block.stiffness = (0.5 * (block.stiffness + block.stiffness.transpose())).eval();
  return result;
}

template <int dim>
bool ElasticMultigrid<dim>::take_blocks(const std::vector<NodeBlock<dim>> &blocks) {
  levels.back().stiffness->set_blocks(blocks);
  for (unsigned int l = levels.size() - 1; l > 0; --l) {
    levels[l].smoother->take_blocks();
    levels[l - 1].stiffness->set_blocks(restricted(levels[l], levels[l - 1]));
  }
  return coarsest->factorize(levels[0].stiffness->node_blocks());
}

template <int dim>
void ElasticMultigrid<dim>::cycle(const unsigned int l) const {
  const Level &level = levels[l];
  if (l == 0) {
    coarsest->solve(level.x, level.b);
    return;
  }
  const Level &below = levels[l - 1];
  level.x = 0.f;
  level.smoother->smooth(level.x, level.b, true);
  level.stiffness->vmult(level.residual, level.x);
  level.residual.sadd(-1.f, 1.f, level.b);
  below.b = 0.f;
  level.transfer.restrict_and_add(below.b, level.residual);
  below.stiffness->set_zero_constrained(below.b);
  cycle(l - 1);
  level.transfer.prolongate_and_add(level.x, below.x);
  level.stiffness->set_zero_constrained(level.x);
  level.smoother->smooth(level.x, level.b, false);
}

template <int dim>
void ElasticMultigrid<dim>::vmult(ContinuumVector &x, const ContinuumVector &b) const {
  const Level &finest = levels.back();
  // A scale of its own keeps the numbers within single precision's range.
  const double size = b.linfty_norm();
  if (size == 0.) {
    x = 0.;
    return;
  }
  for (unsigned int i = 0; i < b.locally_owned_size(); ++i)
    finest.b.local_element(i) = b.local_element(i) / size;
  cycle(levels.size() - 1);
  for (unsigned int i = 0; i < b.locally_owned_size(); ++i)
    x.local_element(i) = size * finest.x.local_element(i);
}

template class ElasticMultigrid<2>;
template class ElasticMultigrid<3>;

} // namespace frictionbeam
