// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/body_cell_matrices.h"
#include "model/body/cell_stiffness.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr std::size_t most_kinds = 8;
constexpr double same_shape = 1e-9; ///< of a cell's size; gmsh places nodes to 1e-11

} // namespace

template <int dim>
BodyCellMatrices<dim>::BodyCellMatrices(const ContinuumBody<dim> &body, const FESystem<dim> &fe)
    : body(body), fe(fe),
      values(body.mapping, fe, QGauss<dim>(fe.degree + 1), update_gradients | update_JxW_values) {}

template <int dim>
FullMatrix<double> BodyCellMatrices<dim>::integrated(const Cell &cell) {
  values.reinit(static_cast<const typename Triangulation<dim>::cell_iterator &>(cell));
  const LameConstants lame = lame_constants(body.continuum, cell->material_id());
  return cell_stiffness(values, fe, lame.lambda, lame.mu, body.thickness());
}

template <int dim>
typename BodyCellMatrices<dim>::Multiple BodyCellMatrices<dim>::kind_of(const Cell &cell) {
  if (!body.mesh.manifolds.empty()) // vertices do not say what a curved cell is
    return {};
  const double size = cell->vertex(1).distance(cell->vertex(0));
  std::vector<Tensor<1, dim>> shape;
  for (const unsigned int v : cell->vertex_indices())
    shape.push_back((cell->vertex(v) - cell->vertex(0)) / size);
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const Kind &other) {
    return cell->material_id() == other.material &&
           std::equal(shape.begin(), shape.end(), other.shape.begin(),
                      [](const auto &a, const auto &b) { return (a - b).norm() <= same_shape; });
  });
  if (found != kinds.end())
    return {static_cast<unsigned int>(found - kinds.begin()), dim == 2 ? 1. : size / found->size};
  if (kinds.size() == most_kinds)
    return {};
  kinds.push_back({cell->material_id(), shape, size, integrated(cell)});
  return {n_kinds() - 1, 1.};
}

template <int dim>
const FullMatrix<double> &BodyCellMatrices<dim>::of(const Cell &cell) {
  const Multiple multiple = kind_of(cell);
  if (multiple.kind == no_kind)
    present = integrated(cell);
  else if (multiple.factor == 1.)
    return of_kind(multiple.kind);
  else {
    present = of_kind(multiple.kind);
    present *= multiple.factor;
  }
  return present;
}

template <int dim>
void assemble_stiffness(
    const ContinuumBody<dim> &body, const DoFHandler<dim> &dof_handler,
    const std::function<void(const FullMatrix<double> &,
                             const std::vector<types::global_dof_index> &)> &add) {
  const auto &fe = dynamic_cast<const FESystem<dim> &>(dof_handler.get_fe());
  BodyCellMatrices<dim> matrices(body, fe);
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned()) {
      cell->get_dof_indices(dofs);
      add(matrices.of(cell), dofs);
    }
}

template class BodyCellMatrices<2>;
template class BodyCellMatrices<3>;
template void
assemble_stiffness<2>(const ContinuumBody<2> &, const DoFHandler<2> &,
                      const std::function<void(const FullMatrix<double> &,
                                               const std::vector<types::global_dof_index> &)> &);
template void
assemble_stiffness<3>(const ContinuumBody<3> &, const DoFHandler<3> &,
                      const std::function<void(const FullMatrix<double> &,
                                               const std::vector<types::global_dof_index> &)> &);

} // namespace frictionbeam
