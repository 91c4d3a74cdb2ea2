// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A pipe that lies on a block of rubber, is heated and cooled, and rubs on it: beams in one
// DoFHandler, a solid in another, and contacts between their vertices. One process or several.
#include "solid.h"

#include <frictionbeam/contact/deal_ii.h>
#include <frictionbeam/fe_timoshenko_beam.h>
#include <frictionbeam/law_library.h>
#include <frictionbeam/line/assemble_line.h>
#include <frictionbeam/line_triangulation.h>
#include <frictionbeam/vertex_dofs.h>

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <cmath>
#include <iostream>

using namespace dealii;
using namespace frictionbeam;

// A steel pipe along x, anchored at 0; the block is under its last 0.4 m. SI units.
const double L = 6., length = 0.4, width = 0.2, height = 0.1, radius = 0.1;
const double EA = 1.2e9, GA = 2.3e8, GJ = 1.5e7, EI = 6.0e6, alpha = 1.2e-5;
const double P = 5e3, f = 0.4;  // on the pipe's end [N], [-]
const unsigned int n_cells = 8; // along the block
const Lame rubber = {1e6, 4e6};

int main(int argc, char **argv) {
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool speaks = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  // The block, distributed among the processes and glued to the ground.
  parallel::shared::Triangulation<3> block(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(block, {n_cells, n_cells / 2, n_cells / 4},
                                            Point<3>(L - length, -width / 2., -radius - height),
                                            Point<3>(L, width / 2., -radius), true);
  DoFHandler<3> block_dofs(block);
  block_dofs.distribute_dofs(FESystem<3>(FE_Q<3>(1), 3));
  AffineConstraints<double> glued;
  VectorTools::interpolate_boundary_values(block_dofs, 4, Functions::ZeroFunction<3>(3), glued);
  glued.close();
  TrilinosWrappers::SparseMatrix K_block;
  assemble_solid(block_dofs, glued, rubber, K_block);

  // The pipe, on every process: one cell up to the block, n_cells above it.
  std::vector<Point<3>> vertices = {Point<3>(0., 0., 0.)};
  std::vector<LineCell> cells;
  for (unsigned int v = 0; v <= n_cells; ++v) {
    vertices.emplace_back(L - length + v * length / n_cells, 0., 0.);
    cells.push_back({{{v, v + 1}}, 0});
  }
  Triangulation<1, 3> pipe;
  create_line_triangulation(vertices, cells, pipe);
  DoFHandler<1, 3> pipe_dofs(pipe);
  pipe_dofs.distribute_dofs(FE_TimoshenkoBeam({12 * EI / GA}));
  const VertexDofs vertex_dofs(pipe_dofs);
  AffineConstraints<double> anchored;
  vertex_dofs.constrain(0, {{true, true, true, true, true, true}}, anchored);
  anchored.close();
  DynamicSparsityPattern places(pipe_dofs.n_dofs());
  DoFTools::make_sparsity_pattern(pipe_dofs, places, anchored, true);
  SparsityPattern pattern;
  pattern.copy_from(places);
  SparseMatrix<double> K_pipe(pattern);
  LawLibrary laws;
  laws.load_builtin();
  const LawDescription &section = laws.find("elastic_section");
  const LineMaterials steel = {
      {0,
       {BoundLaw(section, law_parameters(section, {{"Axial rigidity", EA},
                                                   {"Shear rigidity", GA},
                                                   {"Torsional rigidity", GJ},
                                                   {"Bending rigidity", EI}}))}}};
  assemble_line_stiffness(pipe_dofs, steel, anchored, K_pipe);

  // [between two handlers]
  const unsigned int shift = block_dofs.n_dofs(); // the pipe's dofs follow the block's
  const LawDescription &law = laws.find("coulomb");
  const std::vector<double> parameters = law_parameters(law, {{"Friction coefficient", f}});
  std::vector<contact::Contact> contacts;
  std::vector<double> x; // of each contact
  const Tensor<1, 3> up({0., 0., radius});
  for (unsigned int below = 0; below < block.n_vertices(); ++below)
    for (unsigned int above = 0; above < vertices.size(); ++above)
      if (vertices[above].distance(block.get_vertices()[below] + up) < 1e-9) {
        contacts.push_back(
            contact::between(contact::translations_at_vertex(block_dofs, below),
                             contact::translations_at_vertex(pipe_dofs, above, shift), {0., 0., 1.},
                             law, parameters));
        // The pipe's bottom is a radius below its axis and moves when the pipe turns.
        contacts.back().dofs.push_back(shift + vertex_dofs.index(above, 3));
        contacts.back().rows.push_back({0., radius, 0.});
        contacts.back().dofs.push_back(shift + vertex_dofs.index(above, 4));
        contacts.back().rows.push_back({-radius, 0., 0.});
        x.push_back(vertices[above][0]);
      }
  contact::Solver solver(
      contact::join(contact::system_of(K_block, glued), contact::system_of(K_pipe, anchored)),
      contacts);
  // [end of between two handlers]

  contact::ContactMemory memory = solver.initial_memory();
  contact::Vector u;
  bool passed = contacts.size() == n_cells + 1;
  for (const double temperature : {0., 20., 100., 90., 0.}) { // above installation
    contact::Vector load = contact::Vector::Zero(shift + pipe_dofs.n_dofs());
    load[shift + vertex_dofs.index(n_cells + 1, 2)] = -P;
    load[shift + vertex_dofs.index(n_cells + 1, 0)] = EA * alpha * temperature;
    const contact::Report report = solver.solve(load, memory, u, memory);
    passed = passed && report.converged;
    if (!report.converged) {
      std::cout << report.remark << '\n';
      break;
    }
    double normal = 0., friction = 0., expected = alpha * temperature * L;
    unsigned int n_slip = 0;
    for (unsigned int k = 0; k < contacts.size(); ++k) {
      const contact::ContactState &state = report.contacts[k]; // its force is on the block
      normal += state.normal_force;
      friction += state.force[0];
      expected -= state.force[0] * x[k] / EA; // the pipe is squeezed between there and the anchor
      n_slip += state.status == ContactStatus::slip;
    }
    const double end = u[shift + vertex_dofs.index(n_cells + 1, 0)];
    if (speaks)
      std::cout << temperature << " K: the block carries " << normal << " N, " << n_slip << " of "
                << contacts.size() << " contacts slip and drag it by " << friction
                << " N; the pipe's end at " << end << " m, expected " << expected << '\n';
    passed = passed && std::abs(end - expected) < 1e-9 * alpha * 100. * L &&
             std::abs(friction) <= f * normal * (1. + 1e-9) && normal > P / 10.;
    if (temperature == 100. || temperature == 0.)
      passed = passed && (temperature > 0. ? friction > 0.99 * f * normal : friction <= 0.);
  }
  return passed ? 0 : 1;
}
