// On a mesh that is shared among processes, with artificial cells, each process shall assemble its
// own part: the sum is the matrix of one process, VertexDofs finds what it has.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "host_line.h"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/shared_tria.h>

using namespace host;

int line_shared(int argc, char **argv) {
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm all_processes = MPI_COMM_WORLD;
  const unsigned int n_cells = 12, n_processes = Utilities::MPI::n_mpi_processes(all_processes);
  std::vector<Point<3>> vertices;
  std::vector<LineCell> cells;
  for (unsigned int v = 0; v <= n_cells; ++v)
    vertices.emplace_back(0.3 * v, 0.1 * v, 0.);
  for (unsigned int c = 0; c < n_cells; ++c)
    cells.push_back({{{c, c + 1}}, 0});
  vertices.emplace_back(vertices[n_cells] - Tensor<1, 3>({0., 0., 0.1}));
  cells.push_back({{{n_cells, n_cells + 1}}, 1});
  const hp::FECollection<1, 3> fes(FE_TimoshenkoBeam({shear_flexibility}), FE_FrictionBeam());
  const LineMaterials materials = {
      {0, {elastic(), 2.}},
      {1, {law("coulomb", {{"Axial rigidity", 50.}, {"Shear rigidity", 20.}})}}};

  const auto norms = [&](Triangulation<1, 3> &triangulation) {
    create_line_triangulation(vertices, cells, triangulation);
    DoFHandler<1, 3> dof_handler(triangulation);
    unsigned int n_artificial = 0;
    for (const auto &cell : dof_handler.active_cell_iterators()) {
      n_artificial += cell->is_artificial();
      if (cell->is_locally_owned())
        cell->set_active_fe_index(cell->material_id());
    }
    dof_handler.distribute_dofs(fes);
    const VertexDofs vertex_dofs(dof_handler);
    AffineConstraints<double> constraints;
    vertex_dofs.constrain(0, all, constraints);
    constraints.close();
    FullMatrix<double> K(dof_handler.n_dofs()), M(dof_handler.n_dofs());
    Vector<double> u(dof_handler.n_dofs()), residual(dof_handler.n_dofs());
    for (unsigned int i = 0; i < 3; ++i) // a rigid motion: numbers of dofs differ among meshes
      for (unsigned int v = 0; v < vertices.size(); ++v)
        if (vertex_dofs.index(v, i) != numbers::invalid_dof_index)
          u[vertex_dofs.index(v, i)] = -0.1 * vertices[v][i];
    LawPointData points(dof_handler, materials);
    CHECK(assemble_line(dof_handler, materials, u, {}, constraints, points, K, residual) ==
          LawStatus::ok);
    assemble_line_mass(dof_handler, materials, constraints, M);
    // Each entry is the sum of the processes' parts.
    const bool in_parts =
        dynamic_cast<const parallel::TriangulationBase<1, 3> *>(&triangulation) != nullptr;
    CHECK((n_artificial > 0) == (in_parts && n_processes > 1));
    const MPI_Comm owners = in_parts ? all_processes : MPI_COMM_SELF;
    std::vector<unsigned int> held(dof_handler.n_dofs());
    for (unsigned int i = 0; i < held.size(); ++i)
      held[i] =
          Utilities::MPI::sum(static_cast<unsigned int>(constraints.is_constrained(i)), owners);
    for (FullMatrix<double> *const matrix : {&K, &M})
      for (unsigned int i = 0; i < matrix->m(); ++i)
        for (unsigned int j = 0; j < matrix->n(); ++j)
          (*matrix)(i, j) = Utilities::MPI::sum((*matrix)(i, j), owners);
    for (double &value : residual)
      value = Utilities::MPI::sum(value, owners);
    // What is held has an entry of no meaning on the diagonal.
    for (FullMatrix<double> *const matrix : {&K, &M})
      for (unsigned int i = 0; i < matrix->m(); ++i)
        if (held[i] > 0)
          (*matrix)(i, i) = 0.;
    return std::array<double, 3>{{K.frobenius_norm(), M.frobenius_norm(), residual.l2_norm()}};
  };
  parallel::shared::Triangulation<1, 3> shared(
      all_processes, Triangulation<1, 3>::none, true,
      parallel::shared::Triangulation<1, 3>::partition_zorder);
  Triangulation<1, 3> alone;
  const auto in_parts = norms(shared), at_once = norms(alone);
  for (unsigned int k = 0; k < 3; ++k) {
    CHECK(at_once[k] > 0.1);
    CHECK_NEAR(in_parts[k], at_once[k], 1e-13);
  }
  return check::report();
}
