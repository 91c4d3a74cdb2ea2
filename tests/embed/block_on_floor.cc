// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A solid block that lies on a floor with friction, held by nothing else: pressed down, pushed
// along the floor, and pushed too hard. A deal.II program of its own, on one process or on several.
#include <frictionbeam/contact/deal_ii.h>
#include <frictionbeam/law_library.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <iostream>

using namespace dealii;
using namespace frictionbeam;

// Rubber on concrete. SI units.
const double mu = 1e6, lambda = 4e6, f = 0.6, pressure = 1e4;
const Point<3> size(0.4, 0.2, 0.1);
const unsigned int n_cells = 4; // along the height

// [assembly]
void assemble(const DoFHandler<3> &dof_handler, TrilinosWrappers::SparseMatrix &K,
              Vector<double> &press, Vector<double> &push) {
  const FiniteElement<3> &fe = dof_handler.get_fe();
  const FEValuesExtractors::Vector displacement(0);
  FEValues<3> values(fe, QGauss<3>(2), update_gradients | update_JxW_values);
  FEFaceValues<3> faces(fe, QGauss<2>(2), update_values | update_JxW_values);
  FullMatrix<double> cell_matrix(fe.n_dofs_per_cell());
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(cell);
    cell->get_dof_indices(dofs);
    cell_matrix = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      for (const unsigned int i : values.dof_indices())
        for (const unsigned int j : values.dof_indices())
          cell_matrix(i, j) += (2. * mu * values[displacement].symmetric_gradient(i, q) *
                                    values[displacement].symmetric_gradient(j, q) +
                                lambda * values[displacement].divergence(i, q) *
                                    values[displacement].divergence(j, q)) *
                               values.JxW(q);
    K.add(dofs, cell_matrix);
    for (const auto &face : cell->face_iterators())
      if (face->boundary_id() == 5) { // the top
        faces.reinit(cell, face);
        for (const unsigned int q : faces.quadrature_point_indices())
          for (const unsigned int i : faces.dof_indices()) {
            const Tensor<1, 3> shape = faces[displacement].value(i, q);
            press[dofs[i]] -= shape[2] * faces.JxW(q);
            push[dofs[i]] += shape[0] * faces.JxW(q);
          }
      }
  }
  K.compress(VectorOperation::add);
  Utilities::MPI::sum(press, MPI_COMM_WORLD, press);
  Utilities::MPI::sum(push, MPI_COMM_WORLD, push);
}
// [end of assembly]

int main(int argc, char **argv) {
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  parallel::shared::Triangulation<3> triangulation(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(triangulation, {4 * n_cells, 2 * n_cells, n_cells},
                                            Point<3>(), size, true);
  DoFHandler<3> dof_handler(triangulation);
  dof_handler.distribute_dofs(FESystem<3>(FE_Q<3>(1), 3));
  DynamicSparsityPattern pattern(dof_handler.n_dofs());
  DoFTools::make_sparsity_pattern(dof_handler, pattern);
  SparsityTools::distribute_sparsity_pattern(pattern, dof_handler.locally_owned_dofs(),
                                             MPI_COMM_WORLD,
                                             complete_index_set(dof_handler.n_dofs()));
  TrilinosWrappers::SparseMatrix K;
  K.reinit(dof_handler.locally_owned_dofs(), pattern, MPI_COMM_WORLD);
  Vector<double> press(dof_handler.n_dofs()), push(press);
  assemble(dof_handler, K, press, push);
  AffineConstraints<double> constraints; // none: friction alone holds the block
  constraints.close();

  // [contacts]
  LawLibrary laws;
  laws.load_builtin();
  const LawDescription &law = laws.find("coulomb");
  std::vector<double> parameters = default_parameters(law);
  parameters[parameter_index(law, "Friction coefficient")] = f;
  std::vector<contact::Contact> contacts;
  for (unsigned int v = 0; v < triangulation.n_vertices(); ++v)
    if (triangulation.get_vertices()[v][2] < 1e-9)
      contacts.push_back(contact::on_ground(contact::translations_at_vertex(dof_handler, v),
                                            {0., 0., -1.}, law, parameters));
  contact::Solver solver(contact::system_of(K, constraints), contacts);
  contact::ContactMemory memory = solver.initial_memory();
  contact::Vector u; // of all dofs; none yet
  // [end of contacts]

  // [increments]
  bool passed = true;
  const bool speaks = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  for (const double share : {0., 0.5, 0.9, 1.01}) { // of what friction can hold
    const contact::Vector load =
        pressure * contact::to_eigen(press) + share * f * pressure * contact::to_eigen(push);
    const contact::Report report = solver.solve(load, memory, u, memory);
    if (report.converged) {
      contact::Vector3 floor = contact::Vector3::Zero();
      unsigned int n_slip = 0;
      for (const contact::ContactState &state : report.contacts) {
        floor += state.force;
        n_slip += state.status == ContactStatus::slip ? 1 : 0;
      }
      if (speaks)
        std::cout << "pushed by " << share << " of its friction: " << n_slip << " of "
                  << contacts.size() << " contacts slip, the floor gives " << floor.transpose()
                  << " N; natural map " << report.check.natural_map << "\n";
      const double weight = pressure * size[0] * size[1];
      passed = passed && std::abs(floor[2] - weight) < 1e-8 * weight &&
               std::abs(floor[0] + share * f * weight) < 1e-8 * weight && share < 1.;
    } else {
      if (speaks)
        std::cout << "pushed by " << share << " of its friction: " << report.remark << '\n';
      passed = passed && report.no_equilibrium && share > 1.;
    }
  }
  // [end of increments]
  return passed ? 0 : 1;
}
