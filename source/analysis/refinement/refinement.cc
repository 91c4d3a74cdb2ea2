// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/refinement/estimate.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/distributed/solution_transfer.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/numerics/solution_transfer.h>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

namespace {

/// The estimate above which cells hold the fraction of the sum together.
template <int dim>
double threshold(const ContinuumBody<dim> &body, const dealii::Vector<float> &estimate,
                 const double fraction) {
  std::vector<float> own;
  for (const auto &cell : body.triangulation->active_cell_iterators())
    if (cell->is_locally_owned())
      own.push_back(estimate[cell->active_cell_index()]);
  std::vector<float> all;
  for (const auto &part : Utilities::MPI::all_gather(body.communicator, own))
    all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end(), std::greater<float>());
  double sum = 0.;
  for (const float e : all)
    sum += e;
  double held = 0.;
  for (const float e : all)
    if ((held += e) >= fraction * sum)
      return e * (1. - 1e-4); // equal but for rounding: all of them
  return 0.;
}

template <int dim>
using NodeStatus = std::pair<double, Point<dim>>; ///< status, place

/// Of each node the nearest one of another status, or the number of nodes if there is none: a front
/// passes between two such.
template <int dim>
std::vector<std::size_t> nearest_of_other_status(const std::vector<NodeStatus<dim>> &nodes) {
  std::vector<std::size_t> nearest(nodes.size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (nodes[j].first != nodes[i].first &&
          (nearest[i] == nodes.size() || nodes[i].second.distance(nodes[j].second) <
                                             nodes[i].second.distance(nodes[nearest[i]].second)))
        nearest[i] = j;
  return nearest;
}

/// Flag cells on a surface whose nodes are of different status. @return places between nodes of
/// different status, for all processes
template <int dim>
std::vector<Point<dim>> flag_fronts(const ContinuumBody<dim> &body, const ContinuumState &state) {
  ContinuumVector status;
  body.reinit(status);
  for (unsigned int i = 0; i < body.nodes.size(); ++i)
    status(body.nodes[i].dofs[0]) = 1. + static_cast<int>(state.contacts.status[i]);
  status.update_ghost_values();
  const MappingQ1<dim> mapping;
  const std::vector<Point<dim>> &unit_points = body.fe.get_unit_support_points();
  std::vector<Point<dim>> own;
  std::vector<types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned() || !cell->at_boundary())
      continue;
    cell->get_dof_indices(dofs);
    for (const unsigned int f : cell->face_indices()) {
      if (!cell->face(f)->at_boundary() || body.surface_of(cell->face(f)->boundary_id()) < 0)
        continue;
      std::vector<NodeStatus<dim>> nodes;
      for (unsigned int i = 0; i < body.fe.n_dofs_per_face(f); ++i) {
        const unsigned int k = body.fe.face_to_cell_index(i, f);
        if (body.fe.system_to_component_index(k).first == 0 && status(dofs[k]) > 0.)
          nodes.emplace_back(status(dofs[k]),
                             mapping.transform_unit_to_real_cell(cell, unit_points[k]));
      }
      const std::vector<std::size_t> nearest = nearest_of_other_status(nodes);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::size_t j = nearest[i];
        if (j == nodes.size())
          continue;
        cell->set_refine_flag();
        if (i < j && nearest[j] == i)
          own.push_back(nodes[i].second + 0.5 * (nodes[j].second - nodes[i].second));
      }
    }
  }
  std::vector<Point<dim>> all;
  for (const auto &part : Utilities::MPI::all_gather(body.communicator, own))
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Flag cells on a surface that such a place lies in.
template <int dim>
void flag_cells_at(const std::vector<Point<dim>> &places, const ContinuumBody<dim> &body) {
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned() || !cell->at_boundary())
      continue;
    const BoundingBox<dim> box = cell->bounding_box();
    if (std::any_of(places.begin(), places.end(),
                    [&](const Point<dim> &place) { return box.point_inside(place, 1e-9); }))
      cell->set_refine_flag();
  }
}

/// Refine the flagged cells, and carry @p guess over. Constraints and contact nodes of the body are
/// still those of the mesh before.
template <int dim>
void refine_flagged(ContinuumBody<dim> &body, ContinuumGuess &guess) {
  guess.displacement.update_ghost_values();
  guess.traction.update_ghost_values();
  const std::vector<const ContinuumVector *> fields = {&guess.displacement, &guess.traction};
  ContinuumGuess finer;
  body.remember_flagged_cells();
  const auto new_mesh = [&]() {
    body.triangulation->execute_coarsening_and_refinement();
    body.distribute_dofs();
    body.reinit(finer.displacement);
    body.reinit(finer.traction);
  };
  const auto carry_over = [&](auto &transfer) {
    body.triangulation->prepare_coarsening_and_refinement();
    transfer.prepare_for_coarsening_and_refinement(fields);
    new_mesh();
    std::vector<ContinuumVector *> results = {&finer.displacement, &finer.traction};
    transfer.interpolate(results);
  };
#if DEAL_II_VERSION_GTE(9, 7, 0)
  SolutionTransfer<dim, ContinuumVector> transfer(body.dof_handler); // of any mesh
  carry_over(transfer);
#else
  if (body.is_parallel) {
    parallel::distributed::SolutionTransfer<dim, ContinuumVector> transfer(body.dof_handler);
    carry_over(transfer);
  } else {
    SolutionTransfer<dim, ContinuumVector> transfer(body.dof_handler);
    body.triangulation->prepare_coarsening_and_refinement();
    const std::vector<ContinuumVector> old = {guess.displacement, guess.traction};
    transfer.prepare_for_coarsening_and_refinement(old);
    new_mesh();
    std::vector<ContinuumVector> results = {finer.displacement, finer.traction};
    transfer.interpolate(old, results);
    finer.displacement = results[0];
    finer.traction = results[1];
  }
#endif
  guess = finer;
}

} // namespace

template <int dim>
double refine(ContinuumBody<dim> &body, const dealii::Vector<float> &estimate,
              const double fraction, const ContinuumState &state, ContinuumGuess &guess) {
  const double least = fraction < 1. ? threshold(body, estimate, fraction) : -1.;
  for (const auto &cell : body.triangulation->active_cell_iterators())
    if (cell->is_locally_owned() && estimate[cell->active_cell_index()] >= least)
      cell->set_refine_flag();
  const std::vector<Point<dim>> fronts = flag_fronts(body, state);
  double untouched = 0., all = 0.;
  for (const auto &cell : body.triangulation->active_cell_iterators())
    if (cell->is_locally_owned()) {
      const double own = estimate[cell->active_cell_index()];
      all += own;
      untouched += cell->level() == 0 && !cell->refine_flag_set() ? own : 0.;
    }
  untouched = Utilities::MPI::sum(untouched, body.communicator);
  all = Utilities::MPI::sum(all, body.communicator);
  refine_flagged(body, guess);
  if (fraction < 1. && !fronts.empty()) { // twice: where a zone ends is the last to be known
    flag_cells_at(fronts, body);
    refine_flagged(body, guess);
  }
  body.constrain();
  return all > 0. ? untouched / all : 0.;
}

template double refine<2>(ContinuumBody<2> &, const dealii::Vector<float> &, const double,
                          const ContinuumState &, ContinuumGuess &);
template double refine<3>(ContinuumBody<3> &, const dealii::Vector<float> &, const double,
                          const ContinuumState &, ContinuumGuess &);

} // namespace frictionbeam
