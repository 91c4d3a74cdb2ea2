// SPDX-License-Identifier: LGPL-2.1-or-later
//
// An elastic solid of any deal.II program: what block_on_floor and pipe_on_block assemble.
#pragma once

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/vector.h>

struct Lame {
  double mu, lambda; ///< [Pa]
};

/// The stiffness of a solid, its rows distributed among the processes.
inline void assemble_solid(const dealii::DoFHandler<3> &dof_handler,
                           const dealii::AffineConstraints<double> &constraints,
                           const Lame &material, dealii::TrilinosWrappers::SparseMatrix &K) {
  const dealii::FiniteElement<3> &fe = dof_handler.get_fe();
  const dealii::IndexSet relevant = dealii::DoFTools::extract_locally_relevant_dofs(dof_handler);
  dealii::DynamicSparsityPattern pattern(relevant);
  dealii::DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints);
  dealii::SparsityTools::distribute_sparsity_pattern(pattern, dof_handler.locally_owned_dofs(),
                                                     MPI_COMM_WORLD, relevant);
  K.reinit(dof_handler.locally_owned_dofs(), pattern, MPI_COMM_WORLD);
  const dealii::FEValuesExtractors::Vector u(0);
  dealii::FEValues<3> values(fe, dealii::QGauss<3>(fe.degree + 1),
                             dealii::update_gradients | dealii::update_JxW_values);
  dealii::FullMatrix<double> cell_matrix(fe.n_dofs_per_cell());
  std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(cell);
    cell->get_dof_indices(dofs);
    cell_matrix = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      for (const unsigned int i : values.dof_indices())
        for (const unsigned int j : values.dof_indices())
          cell_matrix(i, j) +=
              (2. * material.mu * values[u].symmetric_gradient(i, q) *
                   values[u].symmetric_gradient(j, q) +
               material.lambda * values[u].divergence(i, q) * values[u].divergence(j, q)) *
              values.JxW(q);
    constraints.distribute_local_to_global(cell_matrix, dofs, K);
  }
  K.compress(dealii::VectorOperation::add);
}

/// The load of a traction [Pa] on all faces of a boundary id, the same on every process.
inline dealii::Vector<double> face_load(const dealii::DoFHandler<3> &dof_handler,
                                        const dealii::types::boundary_id boundary,
                                        const dealii::Tensor<1, 3> &traction) {
  const dealii::FiniteElement<3> &fe = dof_handler.get_fe();
  dealii::FEFaceValues<3> values(fe, dealii::QGauss<2>(fe.degree + 1),
                                 dealii::update_values | dealii::update_JxW_values);
  const dealii::FEValuesExtractors::Vector u(0);
  dealii::Vector<double> load(dof_handler.n_dofs());
  std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (cell->is_locally_owned() && face->boundary_id() == boundary) {
        values.reinit(cell, face);
        cell->get_dof_indices(dofs);
        for (const unsigned int q : values.quadrature_point_indices())
          for (const unsigned int i : values.dof_indices())
            load[dofs[i]] += traction * values[u].value(i, q) * values.JxW(q);
      }
  dealii::Utilities::MPI::sum(load, MPI_COMM_WORLD, load);
  return load;
}
