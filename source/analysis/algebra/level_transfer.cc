// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/level_transfer.h"

namespace frictionbeam {

using namespace dealii;

template <int dim>
void LevelTransfer<dim>::reinit(const Space &fine, const Space &coarse, const bool is_same_mesh,
                                const bool is_parallel) {
  if (!is_parallel) {
    make_matrix(fine, coarse);
    return;
  }
  distributed = std::make_unique<MGTwoLevelTransfer<dim, Vector>>();
  AffineConstraints<float> fine_constraints, coarse_constraints;
  fine_constraints.copy_from(fine.constraints);
  coarse_constraints.copy_from(coarse.constraints);
  if (is_same_mesh)
    distributed->reinit_polynomial_transfer(fine.dof_handler, coarse.dof_handler, fine_constraints,
                                            coarse_constraints);
  else
    distributed->reinit_geometric_transfer(fine.dof_handler, coarse.dof_handler, fine_constraints,
                                           coarse_constraints);
}

template <int dim>
void LevelTransfer<dim>::make_matrix(const Space &fine, const Space &coarse) {
  const auto &fine_fe = fine.dof_handler.get_fe(), &coarse_fe = coarse.dof_handler.get_fe();
  const std::vector<Point<dim>> &unit_points = fine_fe.get_unit_support_points();
  std::vector<types::global_dof_index> fine_dofs(fine_fe.n_dofs_per_cell()),
      coarse_dofs(coarse_fe.n_dofs_per_cell());
  std::vector<bool> is_known(fine.dof_handler.n_dofs(), false);
  std::vector<Eigen::Triplet<float>> entries;
  // A dof's row, from any of the cells that it belongs to: functions are continuous.
  const auto add_row = [&](const types::global_dof_index dof, const unsigned int component,
                           const Point<dim> &in_coarse_cell) {
    is_known[dof] = true;
    for (unsigned int j = 0; j < coarse_dofs.size(); ++j) {
      if (coarse_fe.system_to_component_index(j).first != component)
        continue;
      const double value = coarse_fe.shape_value(j, in_coarse_cell);
      if (std::abs(value) < 1e-12)
        continue;
      if (const auto *const masters = coarse.constraints.get_constraint_entries(coarse_dofs[j]))
        for (const auto &[master, factor] : *masters)
          entries.emplace_back(dof, master, factor * value);
      else
        entries.emplace_back(dof, coarse_dofs[j], value);
    }
  };
  for (const auto &coarse_cell : coarse.dof_handler.active_cell_iterators()) {
    coarse_cell->get_dof_indices(coarse_dofs);
    const auto found = fine.dof_handler.get_triangulation().create_cell_iterator(coarse_cell->id());
    const typename DoFHandler<dim>::cell_iterator parent(
        &fine.dof_handler.get_triangulation(), found->level(), found->index(), &fine.dof_handler);
    for (unsigned int child = 0; child < (parent->is_active() ? 1 : parent->n_children());
         ++child) {
      const auto fine_cell = parent->is_active() ? parent : parent->child(child);
      fine_cell->get_dof_indices(fine_dofs);
      for (unsigned int i = 0; i < fine_dofs.size(); ++i)
        if (!is_known[fine_dofs[i]] && !fine.constraints.is_constrained(fine_dofs[i]))
          add_row(fine_dofs[i], fine_fe.system_to_component_index(i).first,
                  parent->is_active()
                      ? unit_points[i]
                      : GeometryInfo<dim>::child_to_cell_coordinates(unit_points[i], child));
    }
  }
  matrix.resize(fine.dof_handler.n_dofs(), coarse.dof_handler.n_dofs());
  matrix.setFromTriplets(entries.begin(), entries.end());
}

namespace {

using SingleVector = LinearAlgebra::distributed::Vector<float>;

Eigen::Map<Eigen::VectorXf> entries_of(SingleVector &vector) {
  return {vector.begin(), static_cast<Eigen::Index>(vector.size())};
}

Eigen::Map<const Eigen::VectorXf> entries_of(const SingleVector &vector) {
  return {vector.begin(), static_cast<Eigen::Index>(vector.size())};
}

} // namespace

template <int dim>
void LevelTransfer<dim>::prolongate_and_add(Vector &fine, const Vector &coarse) const {
  if (distributed)
    distributed->prolongate_and_add(fine, coarse);
  else
    entries_of(fine) += matrix * entries_of(coarse);
}

template <int dim>
void LevelTransfer<dim>::restrict_and_add(Vector &coarse, const Vector &fine) const {
  if (distributed)
    distributed->restrict_and_add(coarse, fine);
  else
    entries_of(coarse) += matrix.transpose() * entries_of(fine);
}

template class LevelTransfer<2>;
template class LevelTransfer<3>;

} // namespace frictionbeam
