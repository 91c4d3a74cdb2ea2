// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A solid block that lies on a floor with friction, held by nothing else: pressed down, pushed
// along the floor, and pushed too hard. A deal.II program of its own, on one process or on several.
//
//   block_on_floor [FILE]: FILE gets the points of the mesh, see doc/block.py
#include "solid.h"

#include <frictionbeam/contact/deal_ii.h>
#include <frictionbeam/law_library.h>

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>

#include <fstream>
#include <iostream>

using namespace dealii;
using namespace frictionbeam;

// Rubber on concrete. SI units.
const Lame rubber = {1e6, 4e6};
const double f = 0.6, pressure = 1e4;
const Point<3> size(0.4, 0.2, 0.1);
const unsigned int n_cells = 4; // along the height

int main(int argc, char **argv) {
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool speaks = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  parallel::shared::Triangulation<3> triangulation(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(triangulation, {4 * n_cells, 2 * n_cells, n_cells},
                                            Point<3>(), size, true);
  DoFHandler<3> dof_handler(triangulation);
  dof_handler.distribute_dofs(FESystem<3>(FE_Q<3>(1), 3));
  AffineConstraints<double> constraints; // none: friction alone holds the block
  constraints.close();
  TrilinosWrappers::SparseMatrix K;
  assemble_solid(dof_handler, constraints, rubber, K);
  const types::boundary_id top = 5;
  const Tensor<1, 3> down({0., 0., -pressure}), along({f * pressure, 0., 0.});
  const contact::Vector press = contact::to_eigen(face_load(dof_handler, top, down)),
                        push = contact::to_eigen(face_load(dof_handler, top, along));

  // [contacts]
  LawLibrary laws;
  laws.load_builtin();
  const LawDescription &law = laws.find("coulomb");
  std::vector<double> parameters = default_parameters(law);
  parameters[parameter_index(law, "Friction coefficient")] = f;
  std::vector<contact::Contact> contacts;
  std::vector<int> contact_at(triangulation.n_vertices(), -1);
  for (unsigned int v = 0; v < triangulation.n_vertices(); ++v)
    if (triangulation.get_vertices()[v][2] < 1e-9) {
      contact_at[v] = contacts.size();
      contacts.push_back(contact::on_ground(contact::translations_at_vertex(dof_handler, v),
                                            {0., 0., -1.}, law, parameters));
    }
  contact::Solver solver(contact::system_of(K, constraints), contacts);
  contact::ContactMemory memory = solver.initial_memory();
  contact::Vector u; // of all dofs; none yet
  // [end of contacts]

  std::ofstream points(argc > 1 && speaks ? argv[1] : "/dev/null");
  bool passed = true;
  // [increments]
  for (const double share : {0., 0.5, 0.9, 1.01}) { // of what friction can hold
    const contact::Report report = solver.solve(press + share * push, memory, u, memory);
    if (speaks)
      std::cout << "pushed by " << share << " of its friction: ";
    if (!report.converged) {
      if (speaks)
        std::cout << report.remark << '\n';
      passed = passed && report.no_equilibrium && share > 1.;
      continue;
    }
    contact::Vector3 floor = contact::Vector3::Zero();
    unsigned int n_slip = 0, n_open = 0;
    for (const contact::ContactState &state : report.contacts) {
      floor += state.force;
      n_slip += state.status == ContactStatus::slip;
      n_open += state.status == ContactStatus::open;
    }
    if (speaks)
      std::cout << n_slip << " of " << contacts.size() << " contacts slip, " << n_open
                << " are open; the floor pushes by " << floor[0] << " N and carries " << floor[2]
                << " N; natural map " << report.check.natural_map << '\n';
    // [end of increments]
    const double weight = pressure * size[0] * size[1];
    passed = passed && std::abs(floor[2] - weight) < 1e-8 * weight &&
             std::abs(floor[0] + share * f * weight) < 1e-8 * weight && share < 1.;
    for (unsigned int v = 0; v < triangulation.n_vertices(); ++v) {
      points << share << ' ' << triangulation.get_vertices()[v];
      for (const unsigned int dof : contact::translations_at_vertex(dof_handler, v))
        points << ' ' << u[dof];
      if (contact_at[v] >= 0) {
        const contact::ContactState &state = report.contacts[contact_at[v]];
        points << ' ' << static_cast<int>(state.status) << ' ' << state.force.transpose();
      }
      points << '\n';
    }
  }
  return passed ? 0 : 1;
}
