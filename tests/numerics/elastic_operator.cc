// SPDX-License-Identifier: LGPL-2.1-or-later
// A body's matrix-free stiffness shall be the sum of its cells' matrices, each integrated on the
// cell itself, hanging and held dofs taken out: of cells that are all of one kind, of some that are
// and some that are not, and of none, in two and three dimensions, in both precisions; and so its
// diagonal.
#include "../check.h"

#include "analysis/algebra/elastic_operator.h"
#include "base/temporary_folder.h"
#include "model/body/body_cell_matrices.h"
#include "model/body/cell_stiffness.h"
#include "scene/read_scene.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>

#include <fstream>

using namespace frictionbeam;

namespace {

Scene slab(const unsigned int dim, const unsigned int degree, LawLibrary &laws) {
  const TemporaryFolder folder;
  std::ofstream(folder.path + "/slab.prm")
      << "set Scene = slab\nset Model = continuum\nsubsection Slab\n  set Length = 3\nend\n"
      << "subsection Continuum\n  set Cells = 1\n  set Dimension = " << dim
      << "\n  set Degree = " << degree << "\nend\n";
  laws.load_builtin();
  return read_scene(folder.path + "/slab.prm", {}, laws);
}

/// K x and the diagonal of K from the cells' own matrices.
template <int dim>
void assemble(const ContinuumBody<dim> &body, const dealii::Vector<double> &x,
              dealii::Vector<double> &y, dealii::Vector<double> &diagonal) {
  dealii::FEValues<dim> values(body.mapping, body.fe, dealii::QGauss<dim>(body.fe.degree + 1),
                               dealii::update_gradients | dealii::update_JxW_values);
  const LameConstants lame = lame_constants(body.continuum);
  std::vector<dealii::types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(dofs);
    add_to_free_dofs(cell_stiffness(values, body.fe, lame.lambda, lame.mu, body.thickness()), dofs,
                     body.constraints, [&](const auto row, const auto column, const double value) {
                       y[row] += value * x[column];
                       if (row == column)
                         diagonal[row] += value;
                     });
  }
}

template <int dim, typename Number>
void compare(const ContinuumBody<dim> &body, const double tolerance) {
  const ElasticOperator<dim, Number> stiffness(body, body.dof_handler, body.constraints);
  typename ElasticOperator<dim, Number>::Vector x, y;
  stiffness.reinit(x);
  stiffness.reinit(y);
  dealii::Vector<double> input(x.size()), expected(x.size()), diagonal(x.size());
  for (unsigned int i = 0; i < x.size(); ++i) {
    const bool is_free = !body.constraints.is_constrained(i);
    x(i) = input[i] = is_free ? std::sin(7. * i * i) : 0.;
  }
  assemble(body, input, expected, diagonal);
  stiffness.multiply_without_blocks(y, x);
  const double largest = expected.linfty_norm();
  for (unsigned int i = 0; i < x.size(); ++i) {
    CHECK(std::abs(y(i) - expected[i]) <= tolerance * largest);
    CHECK_NEAR(stiffness.diagonal()(i), body.constraints.is_constrained(i) ? 1. : diagonal[i],
               tolerance);
  }
}

/// @param refined the first cell is, so that nodes hang @param distorted part of the inner nodes
template <int dim>
void try_mesh(const unsigned int degree, const bool refined, const bool distorted) {
  LawLibrary laws;
  const Scene scene = slab(dim, degree, laws);
  const ContinuumMesh<dim> mesh = build_continuum_mesh<dim>(scene);
  ContinuumBody<dim> body(scene, mesh);
  body.triangulation->refine_global(dim == 2 ? 2 : 1);
  if (refined) {
    body.triangulation->begin_active()->set_refine_flag();
    body.triangulation->execute_coarsening_and_refinement();
  }
  if (distorted)
    dealii::GridTools::distort_random(0.2, *body.triangulation);
  body.distribute();
  compare<dim, double>(body, 1e-12);
  compare<dim, float>(body, 1e-5);
}

} // namespace

int elastic_operator(int, char **) {
  for (const unsigned int degree : {1, 2, 3}) {
    for (const bool refined : {false, true}) {
      try_mesh<2>(degree, refined, false);
      if (degree < 3)
        try_mesh<3>(degree, refined, false);
    }
    try_mesh<2>(degree, false, true);
  }
  try_mesh<3>(1, false, true);
  try_mesh<3>(2, true, true);
  return check::report();
}
