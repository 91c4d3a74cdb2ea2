// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/generalized_strain.h>
#include <frictionbeam/vertex_dofs.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/full_matrix.h>

namespace line_problem {

using namespace dealii;
using frictionbeam::LocalAxes;
using Rigidities = Tensor<1, 6>; ///< EA, GA_y, GA_z, GJ, EI, EI

/// 12 E I / (kappa G A) of a section.
inline double shear_flexibility(const Rigidities &r) { return 12 * r[4] / r[1]; }

inline const MappingQ1<1, 3> mapping;

template <typename Cell>
std::array<Tensor<1, 3>, 3> axes_of(const Cell &cell) {
  const LocalAxes axes(cell->vertex(1) - cell->vertex(0));
  return {axes.x, axes.y, axes.z};
}

template <typename Cell>
FullMatrix<double> stiffness(const Cell &cell, const Rigidities &rigidities,
                             const unsigned int n_points) {
  FEValues<1, 3> values(mapping, cell->get_fe(), QGauss<1>(n_points),
                        update_values | update_gradients | update_JxW_values);
  values.reinit(typename Triangulation<1, 3>::cell_iterator(cell));
  const LocalAxes axes(cell->vertex(1) - cell->vertex(0));
  const unsigned int n = cell->get_fe().n_dofs_per_cell();
  FullMatrix<double> matrix(n, n);
  for (unsigned int q = 0; q < n_points; ++q)
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j) {
        const auto a = generalized_strain(values, axes, i, q);
        const auto b = generalized_strain(values, axes, j, q);
        for (unsigned int s = 0; s < 6; ++s)
          matrix(i, j) += a[s] * rigidities[s] * b[s] * values.JxW(q);
      }
  return matrix;
}

/// x for A x = b with constrained entries.
inline Vector<double> solve(const FullMatrix<double> &matrix, const Vector<double> &load,
                            const AffineConstraints<double> &constraints) {
  const unsigned int n = matrix.m();
  FullMatrix<double> reduced = matrix;
  Vector<double> rhs = load, x(n);
  for (unsigned int i = 0; i < n; ++i)
    if (constraints.is_constrained(i)) {
      const double value = constraints.get_inhomogeneity(i);
      for (unsigned int j = 0; j < n; ++j) {
        rhs[j] -= matrix(j, i) * value;
        reduced(i, j) = reduced(j, i) = 0.;
      }
      reduced(i, i) = 1.;
    }
  for (unsigned int i = 0; i < n; ++i)
    if (constraints.is_constrained(i))
      rhs[i] = constraints.get_inhomogeneity(i);
  reduced.gauss_jordan();
  reduced.vmult(x, rhs);
  return x;
}

/// Global stiffness of all cells, one section per material id.
inline FullMatrix<double> assemble(const DoFHandler<1, 3> &dofs,
                                   const std::vector<Rigidities> &sections) {
  FullMatrix<double> matrix(dofs.n_dofs(), dofs.n_dofs());
  for (const auto &cell : dofs.active_cell_iterators()) {
    std::vector<types::global_dof_index> indices(cell->get_fe().n_dofs_per_cell());
    cell->get_dof_indices(indices);
    const auto local = stiffness(cell, sections.at(cell->material_id()), 2);
    for (unsigned int i = 0; i < indices.size(); ++i)
      for (unsigned int j = 0; j < indices.size(); ++j)
        matrix(indices[i], indices[j]) += local(i, j);
  }
  return matrix;
}

inline AffineConstraints<double> clamp(const frictionbeam::VertexDofs &vertex_dofs,
                                       const unsigned int vertex) {
  AffineConstraints<double> constraints;
  vertex_dofs.constrain(vertex, {{true, true, true, true, true, true}}, constraints);
  constraints.close();
  return constraints;
}

/// Three components of @p x at a vertex from @p first on.
inline Tensor<1, 3> at(const Vector<double> &x, const frictionbeam::VertexDofs &vertex_dofs,
                       const unsigned int vertex, const unsigned int first) {
  Tensor<1, 3> result;
  for (unsigned int d = 0; d < 3; ++d)
    result[d] = x[vertex_dofs.index(vertex, first + d)];
  return result;
}

inline void add_at(Vector<double> &load, const frictionbeam::VertexDofs &vertex_dofs,
                   const unsigned int vertex, const unsigned int first, const Tensor<1, 3> &value) {
  for (unsigned int d = 0; d < 3; ++d)
    load[vertex_dofs.index(vertex, first + d)] += value[d];
}

} // namespace line_problem
