// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/elastic_operator.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

namespace frictionbeam {

using namespace dealii;

ElasticOperator::ElasticOperator(const ContinuumBody<3> &body) : body(body), cells(body.fe.degree) {
  body.reinit(values);
  body.reinit(own_diagonal);
  read_lines();
  read_cells();
  cells.diagonal_add(own_diagonal.get_values());
  for (const Line &line : lines) { // without what two that hang on one have together
    for (std::size_t k = line.begin; k < line.end; ++k)
      own_diagonal.local_element(masters[k].first) +=
          masters[k].second * masters[k].second * own_diagonal.local_element(line.dof);
    own_diagonal.local_element(line.dof) = 0.;
  }
  own_diagonal.compress(VectorOperation::add);
  body.constraints.set_zero(own_diagonal);
}

void ElasticOperator::read_lines() {
  const Utilities::MPI::Partitioner &places = *values.get_partitioner();
  const IndexSet &all = body.is_parallel ? body.relevant : body.owned;
  for (const auto dof : all) {
    if (!body.constraints.is_constrained(dof))
      continue;
    Line line{places.global_to_local(dof), masters.size(), 0};
    if (const auto *const entries = body.constraints.get_constraint_entries(dof))
      for (const auto &[master, factor] : *entries)
        if (all.is_element(master)) // else it hangs on a neighbour's cell only
          masters.emplace_back(places.global_to_local(master), factor);
    line.end = masters.size();
    lines.push_back(line);
  }
}

void ElasticOperator::read_cells() {
  const Utilities::MPI::Partitioner &places = *values.get_partitioner();
  const unsigned int degree = body.fe.degree, n_nodes = body.fe.base_element(0).n_dofs_per_cell();
  const std::vector<unsigned int> node_of =
      FETools::lexicographic_to_hierarchic_numbering<3>(degree);
  std::vector<unsigned int> order;
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int i = 0; i < n_nodes; ++i)
      order.push_back(body.fe.component_to_system_index(c, node_of[i]));
  const FE_Nothing<3> nothing;
  const QGauss<3> quadrature(degree + 1);
  FEValues<3> values_of_map(body.mapping, nothing, quadrature,
                            update_inverse_jacobians | update_JxW_values);
  std::vector<types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
  ElasticHexahedra::Cell cell_data;
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const LameConstants lame = lame_constants(body.continuum, cell->material_id());
    cell_data.lambda = lame.lambda;
    cell_data.mu = lame.mu;
    cell->get_dof_indices(dofs);
    cell_data.dofs.clear();
    for (const unsigned int k : order)
      cell_data.dofs.push_back(places.global_to_local(dofs[k]));
    values_of_map.reinit(typename Triangulation<3>::cell_iterator(cell));
    cell_data.geometry.clear();
    double change = 0.;
    for (const unsigned int q : values_of_map.quadrature_point_indices()) {
      const DerivativeForm<1, 3, 3> &J = values_of_map.inverse_jacobian(q);
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int d = 0; d < 3; ++d) {
          cell_data.geometry.push_back(J[k][d]);
          change = std::max(change, std::abs(J[k][d] - cell_data.geometry[3 * k + d]));
        }
      cell_data.geometry.push_back(values_of_map.JxW(q) / quadrature.weight(q));
    }
    double size = 0.;
    for (unsigned int k = 0; k < 9; ++k)
      size = std::max(size, std::abs(cell_data.geometry[k]));
    if (change <= 1e-12 * size)
      cell_data.geometry.resize(10);
    cells.add(cell_data);
  }
  cells.close();
}

void ElasticOperator::set_constrained(ContinuumVector &x) const {
  for (const Line &line : lines) {
    double value = 0.;
    for (std::size_t k = line.begin; k < line.end; ++k)
      value += masters[k].second * x.local_element(masters[k].first);
    x.local_element(line.dof) = value;
  }
}

void ElasticOperator::collect_constrained(ContinuumVector &y) const {
  for (const Line &line : lines) {
    const double force = y.local_element(line.dof);
    for (std::size_t k = line.begin; k < line.end; ++k)
      y.local_element(masters[k].first) += masters[k].second * force;
    y.local_element(line.dof) = 0.;
  }
}

void ElasticOperator::vmult(ContinuumVector &y, const ContinuumVector &x) const {
  values.zero_out_ghost_values();
  values.copy_locally_owned_data_from(x);
  values.update_ghost_values();
  set_constrained(values);
  y = 0.;
  cells.multiply_add(values.get_values(), y.get_values());
  collect_constrained(y);
  y.compress(VectorOperation::add);
}

void StiffnessWithContacts::vmult(ContinuumVector &y, const ContinuumVector &x) const {
  stiffness.vmult(y, x);
  for (const Contact &contact : contacts) {
    Eigen::Vector3d value;
    for (unsigned int d = 0; d < 3; ++d)
      value[d] = contact.is_free[d] ? x.local_element(contact.dofs[d]) : 0.;
    const Eigen::Vector3d force = contact.tangent * value;
    for (unsigned int d = 0; d < 3; ++d)
      if (contact.is_free[d])
        y.local_element(contact.dofs[d]) += force[d];
  }
}

} // namespace frictionbeam
