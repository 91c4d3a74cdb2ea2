// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line/full_matrices.h"
#include "model/line/spring_extension.h"

namespace frictionbeam {

using namespace dealii;

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

void add_pipes(const Discretization &discretization, const bool lumped, Triplets &stiffness,
               Triplets &mass) {
  PipeElement element(discretization);
  std::vector<types::global_dof_index> dofs(12);
  for (unsigned int i = 0; i < discretization.pipe_cells().size(); ++i) {
    const auto cell = discretization.pipe_cell(i);
    cell->get_dof_indices(dofs);
    const PipeElement::Matrix12 m = mass_of_cell(cell, lumped, element), k = element.stiffness();
    for (unsigned int row = 0; row < 12; ++row)
      for (unsigned int column = 0; column < 12; ++column) {
        stiffness.emplace_back(dofs[row], dofs[column], k(row, column));
        mass.emplace_back(dofs[row], dofs[column], m(row, column));
      }
  }
}

void add_spring(const Spring &spring, const LineMesh &mesh, const VertexDofs &at,
                Triplets &stiffness) {
  for (unsigned int c = 0; c < 6; ++c) {
    if (spring.stiffness[c] == 0.)
      continue;
    const SpringExtension e(spring, c, mesh, at);
    for (std::size_t i = 0; i < e.dofs.size(); ++i)
      for (std::size_t j = 0; j < e.dofs.size(); ++j)
        stiffness.emplace_back(e.dofs[i], e.dofs[j],
                               spring.stiffness[c] * e.weights[i] * e.weights[j]);
  }
}

} // namespace

PipeElement::Matrix12 mass_of_cell(const Discretization::Cell &cell, const bool lumped,
                                   PipeElement &element) {
  if (!lumped)
    return element.mass(cell);
  element.reinit(cell);
  const double length =
      element.arc() ? element.arc()->length() : (cell->vertex(1) - cell->vertex(0)).norm();
  PipeElement::Matrix12 mass = PipeElement::Matrix12::Zero();
  for (unsigned int c = 0; c < 12; ++c)
    mass(c, c) = c % 6 < 3 ? element.profile().mass * length / 2. : 0.;
  return mass;
}

FullMatrices::FullMatrices(const Scene &scene, const LineMesh &mesh,
                           const Discretization &discretization, const ReducedSpace &space,
                           const bool lumped)
    : K(space.n_dofs(), space.n_dofs()), M(space.n_dofs(), space.n_dofs()),
      C(space.n_dofs(), space.n_unknowns()) {
  Triplets stiffness, mass, map;
  add_pipes(discretization, lumped, stiffness, mass);
  const VertexDofs &at = discretization.vertex_dofs();
  for (const PointMass &point_mass : scene.masses)
    for (const std::string &point : point_mass.points)
      for (unsigned int d = 0; d < 3; ++d) {
        const auto dof = at.index(mesh.points.at(point), d);
        mass.emplace_back(dof, dof, point_mass.mass);
      }
  for (const Spring &spring : scene.springs)
    add_spring(spring, mesh, at, stiffness);
  for (unsigned int dof = 0; dof < space.n_dofs(); ++dof)
    for (const auto &term : space.terms(dof))
      map.emplace_back(dof, term.unknown, term.weight);
  K.setFromTriplets(stiffness.begin(), stiffness.end());
  M.setFromTriplets(mass.begin(), mass.end());
  C.setFromTriplets(map.begin(), map.end());
}

} // namespace frictionbeam
