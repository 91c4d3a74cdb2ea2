// SPDX-License-Identifier: LGPL-2.1-or-later
// The linear part of a long line shall be set up and solved in no more time than a bare deal.II
// loop and one factorization need in the same run, and give the same deflection.
#include "analysis/sequence/load_sequence.h"
#include "model/line_model.h"
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/generalized_strain.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/timer.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/tria_description.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/SparseCholesky>

#include <iostream>

using namespace dealii;
using namespace frictionbeam;

namespace {

/// A pipe carried every 6 m and anchored at its ends, under its own weight.
Scene make_scene() {
  Scene scene;
  scene.materials.push_back({"steel", 2e11, 0.3, 7850., 1.2e-5});
  Section section;
  section.name = "DN300";
  section.area = 9.38e-3;
  section.inertia = 1.16e-4;
  section.torsion_constant = 2.32e-4;
  section.shear_area = 4.69e-3;
  scene.sections.push_back(section);
  Pipe pipe;
  pipe.name = "main";
  scene.pipes.push_back(pipe);
  Load weight;
  weight.name = "weight";
  weight.vector = Vector3({0., 0., -9.81});
  scene.loads.push_back(weight);
  Restraint anchor;
  anchor.name = "anchor";
  anchor.fixed.fill(true);
  scene.restraints.push_back(anchor);
  Restraint carried;
  carried.name = "carried";
  carried.fixed = {{false, false, true, false, false, false}};
  scene.restraints.push_back(carried);
  LoadStep step;
  step.name = "weight";
  step.loads = {{0, 1.}};
  scene.steps.push_back(step);
  return scene;
}

std::vector<unsigned int> carried_vertices(const unsigned int n_cells) {
  std::vector<unsigned int> vertices;
  for (unsigned int v = 6; v < n_cells; v += 6)
    vertices.push_back(v);
  return vertices;
}

/// @p n_cells cells of 1 m along x, turning by a quarter every 50 cells.
LineMesh make_mesh(const unsigned int n_cells) {
  LineMesh mesh;
  MeshedPipe pipe;
  Point3 position;
  for (unsigned int i = 0; i <= n_cells; ++i) {
    mesh.vertices.push_back(position);
    pipe.vertices.push_back(i);
    pipe.s.push_back(i);
    position[(i / 50) % 2] += 1.;
  }
  pipe.bend_radius.assign(n_cells, 0.);
  mesh.pipes.push_back(pipe);
  mesh.restraints.push_back({{0, Vector3({1., 0., 0.}), 1.}, {n_cells, Vector3({1., 0., 0.}), 1.}});
  mesh.restraints.emplace_back();
  for (const unsigned int v : carried_vertices(n_cells))
    mesh.restraints.back().push_back({v, Vector3({1., 0., 0.}), 1.});
  return mesh;
}

/// A vertex in the middle of the line and of a span.
unsigned int observed(const LineMesh &mesh) { return mesh.vertices.size() / 12 * 6 + 3; }

struct Outcome {
  double seconds = 0., deflection = 0.;
};

Outcome solve_with_application(const Scene &scene, const LineMesh &mesh, const LawLibrary &laws) {
  const Timer timer;
  const LineModel line(scene, mesh, laws);
  const double assembled = timer.wall_time();
  LoadSequence sequence(line.model());
  const bool converged = sequence.run([](const Progress &, const LineState &) {});
  const double seconds = timer.wall_time();
  std::cout << "  model " << assembled << " s, solution " << seconds - assembled << " s, "
            << (converged ? "residual " : "NOT converged, residual ")
            << sequence.reports().back().residual << '\n';
  const auto dof = line.model().discretization.vertex_dofs().index(observed(mesh), 2);
  return {seconds, sequence.state().dofs[dof]};
}

/// Triangulation, degrees of freedom, sparsity, one FEValues assembly, one SimplicialLDLT.
Outcome solve_bare(const Scene &scene, const LineMesh &mesh) {
  const Material &material = scene.materials[0];
  const Section &section = scene.sections[0];
  const double E = material.youngs_modulus, G = E / (2. * (1. + material.poissons_ratio));
  const double D[6] = {E * section.area,       G * section.shear_area,
                       G * section.shear_area, G * section.torsion_constant,
                       E * section.inertia,    E * section.inertia};
  const double weight = -9.81 * material.density * section.area;

  const Timer timer;
  std::vector<CellData<1>> cells(mesh.vertices.size() - 1);
  for (unsigned int i = 0; i < cells.size(); ++i)
    cells[i].vertices = {i, i + 1};
  Triangulation<1, 3> triangulation;
  triangulation.create_triangulation(mesh.vertices, cells, SubCellData());
  const FE_TimoshenkoBeam fe({12. * D[4] / D[1]});
  DoFHandler<1, 3> dofs(triangulation);
  dofs.distribute_dofs(fe);
  DynamicSparsityPattern dynamic(dofs.n_dofs());
  DoFTools::make_sparsity_pattern(dofs, dynamic);
  SparsityPattern pattern;
  pattern.copy_from(dynamic);
  dealii::SparseMatrix<double> matrix(pattern);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(dofs.n_dofs());
  FEValues<1, 3> values(fe, QGauss<1>(2), update_values | update_gradients | update_JxW_values);
  FullMatrix<double> local(12, 12);
  std::vector<types::global_dof_index> indices(12);
  std::array<GeneralizedStrain, 12> strain;
  for (const auto &cell : dofs.active_cell_iterators()) {
    values.reinit(cell);
    const LocalAxes axes(cell->vertex(1) - cell->vertex(0));
    local = 0.;
    cell->get_dof_indices(indices);
    for (const unsigned int q : {0u, 1u}) {
      for (unsigned int i = 0; i < 12; ++i) {
        strain[i] = generalized_strain(values, axes, i, q);
        forces[indices[i]] += weight * values.shape_value_component(i, q, 2) * values.JxW(q);
      }
      for (unsigned int i = 0; i < 12; ++i)
        for (unsigned int j = 0; j < 12; ++j)
          for (unsigned int c = 0; c < 6; ++c)
            local(i, j) += strain[i][c] * D[c] * strain[j][c] * values.JxW(q);
    }
    matrix.add(indices, local);
  }
  // Both ends clamped, the rest carried; then to Eigen, in the numbering along the line.
  const unsigned int n = dofs.n_dofs();
  Eigen::SparseMatrix<double> stiffness(n, n);
  stiffness.reserve(Eigen::VectorXi::Constant(n, 18));
  for (unsigned int i = 0; i < n; ++i)
    for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
      if (entry->column() >= i) // rows are columns: lower part, sorted
        stiffness.insert(entry->column(), i) = entry->value();
  const VertexDofs vertex_dofs(dofs);
  for (const unsigned int v : {0u, static_cast<unsigned int>(mesh.vertices.size() - 1)})
    for (unsigned int c = 0; c < 6; ++c) {
      stiffness.coeffRef(vertex_dofs.index(v, c), vertex_dofs.index(v, c)) *= 1e20;
      forces[vertex_dofs.index(v, c)] = 0.;
    }
  for (const unsigned int v : carried_vertices(mesh.vertices.size() - 1))
    stiffness.coeffRef(vertex_dofs.index(v, 2), vertex_dofs.index(v, 2)) *= 1e20;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
      factors(stiffness);
  const Eigen::VectorXd solution = factors.solve(forces);
  return {timer.wall_time(), solution[vertex_dofs.index(observed(mesh), 2)]};
}

} // namespace

int main(int argc, char **argv) {
  const unsigned int n_cells = argc > 1 ? std::stoul(argv[1]) : 200000;
  LawLibrary laws;
  laws.load_builtin();
  const Scene scene = make_scene();
  const LineMesh mesh = make_mesh(n_cells);
  std::vector<double> ratios;
  for (unsigned int repetition = 0; repetition < 7; ++repetition) {
    Outcome bare, ours;
    const bool bare_first = repetition % 2 == 0;
    for (const bool is_bare : {bare_first, !bare_first})
      if (is_bare)
        bare = solve_bare(scene, mesh);
      else
        ours = solve_with_application(scene, mesh, laws);
    ratios.push_back(ours.seconds / bare.seconds);
    std::cout << n_cells << " cells: bare " << bare.seconds << " s, FrictionBeam " << ours.seconds
              << " s, ratio " << ratios.back() << "; deflection " << bare.deflection << " and "
              << ours.deflection << " m\n";
  }
  std::sort(ratios.begin(), ratios.end());
  std::cout << "median ratio " << ratios[3] << " (goal: at most 1)\n";
  return ratios[3] <= 1. ? 0 : 1;
}
