// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/pressure_stiffness.h"

#include "model/body/wall_loads.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values_extractors.h>

#include <Eigen/Core>

namespace frictionbeam {

using namespace dealii;

namespace {

bool is_at_bore(const PipeWall &wall, const unsigned int cell) {
  return cell / wall.around % wall.through == 0;
}

} // namespace

PressureCells::PressureCells(const PressureStiffness &of)
    : of(of), values(of.body.mapping, of.body.fe, QGauss<3>(of.body.fe.degree + 1),
                     update_gradients | update_JxW_values),
      on_bore(of.body.mapping, of.body.fe, QGauss<2>(of.body.fe.degree + 2),
              update_values | update_gradients | update_normal_vectors | update_JxW_values) {}

FullMatrix<double> PressureCells::of_cell(const Cell &cell) {
  FullMatrix<double> matrix(of.body.fe.n_dofs_per_cell(), of.body.fe.n_dofs_per_cell());
  add_stress(cell, matrix);
  if (is_at_bore(of.wall, cell->index()))
    add_bore(cell, matrix);
  return matrix;
}

void PressureCells::add_stress(const Cell &cell, FullMatrix<double> &matrix) {
  values.reinit(cell);
  const FESystem<3> &fe = of.body.fe;
  const LameConstants lame = lame_constants(of.body.continuum, cell->material_id());
  const unsigned int n = fe.n_dofs_per_cell() / 3, n_q = values.n_quadrature_points;
  std::vector<Tensor<2, 3>> strains(n_q);
  values[FEValuesExtractors::Vector(0)].get_function_gradients(of.free_field, strains);
  Eigen::MatrixXd gradient(3 * n_q, n), pulled(3 * n_q, n);
  for (unsigned int q = 0; q < n_q; ++q) {
    const SymmetricTensor<2, 3> stress = values.JxW(q) * WallLoads::stress(lame, strains[q], 0.);
    for (unsigned int i = 0; i < n; ++i) {
      const Tensor<1, 3> &g = values.shape_grad(fe.component_to_system_index(0, i), q),
                         pull = stress * g;
      for (unsigned int d = 0; d < 3; ++d) {
        gradient(3 * q + d, i) = g[d];
        pulled(3 * q + d, i) = pull[d];
      }
    }
  }
  const Eigen::MatrixXd products = gradient.transpose() * pulled;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int a = 0; a < 3; ++a)
        matrix(fe.component_to_system_index(a, i), fe.component_to_system_index(a, j)) +=
            products(i, j);
}

void PressureCells::add_bore(const Cell &cell, FullMatrix<double> &matrix) {
  // V''(u, v) = int (div u) n.v - n.(grad u) v over the bore, n out of the fluid, whose derivatives
  // across the surface cancel.
  on_bore.reinit(cell, 0);
  const FESystem<3> &fe = of.body.fe;
  for (unsigned int i = 0; i < matrix.m(); ++i) {
    const auto [a, node] = fe.system_to_component_index(i);
    if (!fe.has_support_on_face(i, 0))
      continue;
    for (unsigned int j = 0; j < matrix.n(); ++j) {
      const unsigned int b = fe.system_to_component_index(j).first;
      if (a == b)
        continue;
      for (const unsigned int q : on_bore.quadrature_point_indices()) {
        const Tensor<1, 3> &g = on_bore.shape_grad(j, q), &into_bore = on_bore.normal_vector(q);
        matrix(i, j) += on_bore.JxW(q) * on_bore.shape_value(i, q) *
                        (g[b] * into_bore[a] - g[a] * into_bore[b]);
      }
    }
  }
}

void PressureStiffness::assemble(const Add &add) const {
  PressureCells cells(*this);
  std::vector<types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    cell->get_dof_indices(dofs);
    add(cells.of_cell(cell), dofs);
  }
  for (const bool is_end : {false, true}) {
    const BoreLoop loop(wall, body, is_end ? wall.rings.size() - 1 : 0);
    FullMatrix<double> cap = loop.matrix();
    cap *= is_end ? -1. : 1.; // of - V
    add(cap, loop.dofs());
  }
}

ContinuumVector PressureStiffness::times_free_field() const {
  ContinuumVector result;
  body.reinit(result);
  assemble([&](const FullMatrix<double> &matrix, const std::vector<types::global_dof_index> &dofs) {
    Vector<double> u(dofs.size()), force(dofs.size());
    for (unsigned int i = 0; i < dofs.size(); ++i)
      u[i] = free_field(dofs[i]);
    matrix.vmult(force, u);
    body.constraints.distribute_local_to_global(force, dofs, result);
  });
  return result;
}

ContinuumVector volume_gradient(const PipeWall &wall, const ContinuumBody<3> &body) {
  ContinuumVector forces;
  body.reinit(forces);
  FEFaceValues<3> on_bore(body.mapping, body.fe, QGauss<2>(body.fe.degree + 2),
                          update_values | update_normal_vectors | update_JxW_values);
  Vector<double> local(body.fe.n_dofs_per_cell());
  std::vector<types::global_dof_index> dofs(local.size());
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    if (!is_at_bore(wall, cell->index()))
      continue;
    on_bore.reinit(cell, 0);
    local = 0.;
    for (unsigned int i = 0; i < local.size(); ++i)
      for (const unsigned int q : on_bore.quadrature_point_indices())
        local[i] -= on_bore.JxW(q) * on_bore.shape_value(i, q) *
                    on_bore.normal_vector(q)[body.fe.system_to_component_index(i).first];
    cell->get_dof_indices(dofs);
    body.constraints.distribute_local_to_global(local, dofs, forces);
  }
  for (const bool is_end : {false, true}) {
    const BoreLoop loop(wall, body, is_end ? wall.rings.size() - 1 : 0);
    Vector<double> cap = loop.gradient();
    cap *= is_end ? 1. : -1.;
    body.constraints.distribute_local_to_global(cap, loop.dofs(), forces);
  }
  return forces;
}

} // namespace frictionbeam
