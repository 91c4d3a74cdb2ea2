// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/linear_elements.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

namespace frictionbeam {

using namespace dealii;

LinearElements::LinearElements(const ContinuumBody<3> &body)
    : dof_handler(*body.triangulation), body(body) {
  dof_handler.distribute_dofs(FESystem<3>(FE_Q<3>(1), 3));
  owned = dof_handler.locally_owned_dofs();
  relevant = DoFTools::extract_locally_relevant_dofs(dof_handler);
  constrain();
  ContinuumVector vector;
  reinit(vector);
  places = vector.get_partitioner();
  interpolate();
}

void LinearElements::reinit(ContinuumVector &vector) const {
  if (body.is_parallel)
    vector.reinit(owned, relevant, body.communicator);
  else
    vector.reinit(dof_handler.n_dofs());
}

void LinearElements::constrain() {
  constraints.reinit(relevant);
  DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  // Vertices are held as the body's are; where one moves along with its own other dofs, as well.
  std::map<types::global_dof_index, types::global_dof_index> own_dof; // by the body's
  const auto fine_cells = body.dof_handler.active_cell_iterators();
  auto fine = fine_cells.begin();
  for (auto cell = dof_handler.begin_active(); cell != dof_handler.end(); ++cell, ++fine)
    if (!cell->is_artificial())
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int d = 0; d < 3; ++d)
          own_dof[(*fine)->vertex_dof_index(v, d)] = cell->vertex_dof_index(v, d);
  for (const auto &[fine_dof, dof] : own_dof) {
    if (!body.constraints.is_constrained(fine_dof) || constraints.is_constrained(dof))
      continue;
    std::vector<std::pair<types::global_dof_index, double>> masters;
    bool are_vertices = true;
    for (const auto &[master, factor] : *body.constraints.get_constraint_entries(fine_dof)) {
      const auto found = own_dof.find(master);
      are_vertices = are_vertices && found != own_dof.end();
      if (are_vertices)
        masters.emplace_back(found->second, factor);
    }
    if (!are_vertices)
      continue;
    constraints.add_line(dof);
    constraints.add_entries(dof, masters);
  }
  constraints.close();
}

void LinearElements::interpolate() {
  ContinuumVector of_body;
  body.reinit(of_body);
  const Utilities::MPI::Partitioner &fine_places = *of_body.get_partitioner();
  const unsigned int n_fine = fine_places.locally_owned_size();
  std::vector<std::vector<std::pair<unsigned int, double>>> rows(n_fine);
  const FiniteElement<3> &linear = dof_handler.get_fe();
  const std::vector<Point<3>> &nodes = body.fe.get_unit_support_points();
  std::vector<types::global_dof_index> fine_dofs(body.fe.n_dofs_per_cell()),
      dofs(linear.n_dofs_per_cell());
  auto fine = body.dof_handler.begin_active();
  for (auto cell = dof_handler.begin_active(); cell != dof_handler.end(); ++cell, ++fine) {
    if (!cell->is_locally_owned())
      continue;
    fine->get_dof_indices(fine_dofs);
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < fine_dofs.size(); ++i) {
      if (!body.owned.is_element(fine_dofs[i]) || body.constraints.is_constrained(fine_dofs[i]))
        continue;
      auto &row = rows[fine_places.global_to_local(fine_dofs[i])];
      if (!row.empty())
        continue;
      std::map<unsigned int, double> sum;
      const unsigned int component = body.fe.system_to_component_index(i).first;
      for (const unsigned int v : cell->vertex_indices()) {
        const unsigned int k = linear.component_to_system_index(component, v);
        const double value = linear.shape_value(k, nodes[i]);
        if (std::abs(value) < 1e-14)
          continue;
        if (!constraints.is_constrained(dofs[k]))
          sum[places->global_to_local(dofs[k])] += value;
        else
          for (const auto &[master, factor] : *constraints.get_constraint_entries(dofs[k]))
            sum[places->global_to_local(master)] += factor * value;
      }
      row.assign(sum.begin(), sum.end());
    }
  }
  row_begin.assign(1, 0);
  for (const auto &row : rows) {
    entries.insert(entries.end(), row.begin(), row.end());
    row_begin.push_back(entries.size());
  }
}

void LinearElements::prolongate_add(ContinuumVector &fine, ContinuumVector &coarse) const {
  coarse.update_ghost_values();
  for (std::size_t i = 0; i + 1 < row_begin.size(); ++i) {
    double sum = 0.;
    for (std::size_t k = row_begin[i]; k < row_begin[i + 1]; ++k)
      sum += entries[k].second * coarse.local_element(entries[k].first);
    fine.local_element(i) += sum;
  }
  coarse.zero_out_ghost_values();
}

void LinearElements::restrict_to(ContinuumVector &coarse, const ContinuumVector &fine) const {
  coarse = 0.;
  for (std::size_t i = 0; i + 1 < row_begin.size(); ++i)
    for (std::size_t k = row_begin[i]; k < row_begin[i + 1]; ++k)
      coarse.local_element(entries[k].first) += entries[k].second * fine.local_element(i);
  coarse.compress(VectorOperation::add);
}

std::vector<std::pair<types::global_dof_index, double>>
LinearElements::row(const unsigned int dof) const {
  std::vector<std::pair<types::global_dof_index, double>> result;
  for (std::size_t k = row_begin[dof]; k < row_begin[dof + 1]; ++k)
    result.emplace_back(places->local_to_global(entries[k].first), entries[k].second);
  return result;
}

void LinearElements::assemble_stiffness(
    const std::function<void(const FullMatrix<double> &,
                             const std::vector<types::global_dof_index> &)> &add) const {
  const QGauss<3> quadrature(2);
  const FE_Q<3> shapes(1);
  FEValues<3> values(body.mapping, shapes, quadrature, update_gradients | update_JxW_values);
  const FiniteElement<3> &fe = dof_handler.get_fe();
  const unsigned int n = shapes.n_dofs_per_cell();
  FullMatrix<double> matrix(3 * n, 3 * n);
  std::vector<types::global_dof_index> dofs(3 * n);
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(typename Triangulation<3>::cell_iterator(cell));
    const LameConstants lame = lame_constants(body.continuum, cell->material_id());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j) {
        Tensor<2, 3> products; // of derivatives
        for (const unsigned int q : values.quadrature_point_indices())
          products +=
              values.JxW(q) * outer_product(values.shape_grad(i, q), values.shape_grad(j, q));
        const double both = lame.mu * trace(products);
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            matrix(fe.component_to_system_index(a, i), fe.component_to_system_index(b, j)) =
                lame.lambda * products[a][b] + lame.mu * products[b][a] + (a == b ? both : 0.);
      }
    cell->get_dof_indices(dofs);
    add(matrix, dofs);
  }
}

std::vector<ContinuumVector> LinearElements::rigid_motions() const {
  std::vector<ContinuumVector> motions(6);
  for (ContinuumVector &motion : motions)
    reinit(motion);
  Point<3> middle;
  double size = 0.;
  for (const Point<3> &vertex : body.mesh.vertices)
    middle += vertex / double(body.mesh.vertices.size());
  for (const Point<3> &vertex : body.mesh.vertices)
    size = std::max(size, vertex.distance(middle));
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (!cell->is_artificial())
      for (const unsigned int v : cell->vertex_indices()) {
        const Tensor<1, 3> x = (cell->vertex(v) - middle) / size;
        for (unsigned int d = 0; d < 3; ++d) {
          const types::global_dof_index dof = cell->vertex_dof_index(v, d);
          if (!owned.is_element(dof) || constraints.is_constrained(dof))
            continue;
          motions[d](dof) = 1.;
          const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
          motions[3 + e](dof) = x[f];  // about axis e
          motions[3 + f](dof) = -x[e]; // about axis f
        }
      }
  return motions;
}

} // namespace frictionbeam
