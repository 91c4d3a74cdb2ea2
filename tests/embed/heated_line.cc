// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A pipe that is heated from one end, and cooled again: the heat equation on the line, its thermal
// expansion, and a support with friction at the far end. A deal.II program of its own.
#include <frictionbeam/contact/deal_ii.h>
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/law_library.h>
#include <frictionbeam/line/assemble_line.h>
#include <frictionbeam/line_triangulation.h>
#include <frictionbeam/vertex_dofs.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/numerics/matrix_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace dealii;
using namespace frictionbeam;

// A steel pipe of 10 m. SI units.
const double L = 10., EA = 1.2e9, GA = 2.3e8, GJ = 1.5e7, EI = 2.0e7, alpha = 1.2e-5;
const double diffusivity = 1.2e-5, hot = 80.; // [m2/s], [K] above installation
const double P = 2e4, f = 0.4;                // at the support [N], [-]
const unsigned int n_cells = 10, n_steps = 60;
const double step = 3e5; // [s]

/// Temperatures of a line whose first vertex is given one.
class Heat {
public:
  explicit Heat(const Triangulation<1, 3> &triangulation);
  void advance(const double at_first_vertex);
  /// Mean over a cell.
  double mean(const typename Triangulation<1, 3>::cell_iterator &cell) const;

private:
  const FE_Q<1, 3> fe;
  DoFHandler<1, 3> dof_handler;
  SparsityPattern pattern;
  SparseMatrix<double> mass, system;
  Vector<double> temperature;
};

// [heat]
Heat::Heat(const Triangulation<1, 3> &triangulation) : fe(1), dof_handler(triangulation) {
  dof_handler.distribute_dofs(fe);
  DynamicSparsityPattern places(dof_handler.n_dofs());
  DoFTools::make_sparsity_pattern(dof_handler, places);
  pattern.copy_from(places);
  mass.reinit(pattern);
  system.reinit(pattern);
  temperature.reinit(dof_handler.n_dofs());
  FEValues<1, 3> values(fe, QGauss<1>(2), update_values | update_gradients | update_JxW_values);
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(dofs);
    for (const unsigned int q : values.quadrature_point_indices())
      for (const unsigned int i : values.dof_indices())
        for (const unsigned int j : values.dof_indices()) {
          const double m = values.shape_value(i, q) * values.shape_value(j, q) * values.JxW(q),
                       k = values.shape_grad(i, q) * values.shape_grad(j, q) * values.JxW(q);
          mass.add(dofs[i], dofs[j], m);
          system.add(dofs[i], dofs[j], m + step * diffusivity * k);
        }
  }
}

void Heat::advance(const double at_first_vertex) {
  Vector<double> right(temperature.size());
  mass.vmult(right, temperature);
  SparseMatrix<double> matrix(pattern);
  matrix.copy_from(system);
  std::map<types::global_dof_index, double> given;
  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (cell->vertex_index(v) == 0)
        given[cell->vertex_dof_index(v, 0)] = at_first_vertex;
  MatrixTools::apply_boundary_values(given, matrix, temperature, right);
  SparseDirectUMFPACK inverse;
  inverse.initialize(matrix);
  inverse.vmult(temperature, right);
}
// [end of heat]

double Heat::mean(const typename Triangulation<1, 3>::cell_iterator &cell) const {
  const typename DoFHandler<1, 3>::cell_iterator here(&cell->get_triangulation(), cell->level(),
                                                      cell->index(), &dof_handler);
  return (temperature[here->vertex_dof_index(0, 0)] + temperature[here->vertex_dof_index(1, 0)]) /
         2.;
}

int main() {
  std::vector<Point<3>> vertices;
  std::vector<LineCell> cells;
  for (unsigned int v = 0; v <= n_cells; ++v)
    vertices.emplace_back(L * v / n_cells, 0., 0.);
  for (unsigned int c = 0; c < n_cells; ++c)
    cells.push_back({{{c, c + 1}}, 0});
  Triangulation<1, 3> triangulation;
  create_line_triangulation(vertices, cells, triangulation);
  Heat heat(triangulation);
  DoFHandler<1, 3> dof_handler(triangulation);
  dof_handler.distribute_dofs(FE_TimoshenkoBeam({12 * EI / GA}));
  const VertexDofs vertex_dofs(dof_handler);
  AffineConstraints<double> constraints;
  vertex_dofs.constrain(0, {{true, true, true, true, true, true}}, constraints);
  constraints.close();
  DynamicSparsityPattern places(dof_handler.n_dofs());
  DoFTools::make_sparsity_pattern(dof_handler, places, constraints, true);
  SparsityPattern pattern;
  pattern.copy_from(places);
  SparseMatrix<double> K(pattern);
  LawLibrary laws;
  laws.load_builtin();
  const LawDescription &section = laws.find("elastic_section");
  const LineMaterials pipe = {
      {0,
       {BoundLaw(section, law_parameters(section, {{"Axial rigidity", EA},
                                                   {"Shear rigidity", GA},
                                                   {"Torsional rigidity", GJ},
                                                   {"Bending rigidity", EI}}))}}};
  assemble_line_stiffness(dof_handler, pipe, constraints, K);

  // [support]
  const LawDescription &law = laws.find("coulomb");
  contact::Solver solver(
      contact::system_of(K, constraints),
      {contact::on_ground(contact::translations_at_vertex(dof_handler, n_cells), {0., 0., -1.}, law,
                          law_parameters(law, {{"Friction coefficient", f}}))});
  contact::ContactMemory memory = solver.initial_memory();
  contact::Vector u;
  // [end of support]

  // [steps]
  const auto end = [&](const unsigned int c) { return vertex_dofs.index(n_cells, c); };
  const Vector<double> at_rest(dof_handler.n_dofs());
  LawPointData points(dof_handler, pipe);
  LineIncrement heated;
  heated.free_strain = [&heat](const LineCellIterator &cell, const Point<3> &) {
    return GeneralizedStrain({alpha * heat.mean(cell), 0., 0., 0., 0., 0.});
  };
  double expected = 0., largest = 0.;
  bool passed = true;
  for (unsigned int k = 0; k <= n_steps; ++k) {
    if (k > 0)
      heat.advance(k <= n_steps / 2 ? hot : 0.);
    double expansion = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      expansion += alpha * heat.mean(cell) * cell->measure();
    Vector<double> load(dof_handler.n_dofs());
    load[end(2)] = -P;
    // What free strains push with is the residual of the pipe at rest.
    passed = assemble_line(dof_handler, pipe, at_rest, heated, constraints, points, load) ==
                 LawStatus::ok &&
             passed;
    const contact::Report report = solver.solve(contact::to_eigen(load), memory, u, memory);
    // The support holds the end where its friction can, and lets it go no farther than it must.
    const double most = f * P * L / EA;
    expected = std::clamp(expected, expansion - most, expansion + most);
    largest = std::max(largest, expected);
    passed = passed && report.converged && std::abs(u[end(0)] - expected) < 1e-9 * alpha * hot * L;
    if (k % 10 == 0)
      std::cout << "day " << k * step / 86400. << ": free expansion " << expansion
                << " m, the end at " << u[end(0)] << " m, expected " << expected << ", friction "
                << report.contacts[0].force[0] << " N\n";
  }
  // [end of steps]
  return passed && largest > 1e-3 ? 0 : 1;
}
