// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/corotational_cells.h"
#include "model/cell/rotation.h"
#include "model/line/modal_damping.h"
#include "model/line/spring_extension.h"

namespace frictionbeam {

using namespace dealii;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Modal damping of small motions is C = sum 2 zeta w (M phi)(M phi)^T. With M
// phi = K phi / w^2 and K = sum B^T K_7 B of cells, and of springs, it is sum 2
// zeta/w^3 g g^T with g = sum B^T (K_7 B_0 phi): forces on the cells'
// deformations by rates of these. Such forces go along with the cells.

void CorotationalCells::find_damped_modes() {
  const Modes modes = modes_to_damp(linear.stiffness(), linear.mass());
  unsigned int n = 0;
  for (int i = 0; i < modes.frequencies.size(); ++i)
    n += modes.frequencies[i] > 0.;
  mode_forces.setZero(7 * cells.size() + 6 * scene.springs.size(), n);
  mode_damping.resize(n);
  const Pose rest = at_rest();
  Vector dofs;
  for (int i = 0, m = 0; i < modes.frequencies.size(); ++i) {
    const double w = modes.frequencies[i];
    if (w == 0.) // moves freely
      continue;
    mode_damping[m] = 2. * scene.time.modal_damping / (w * w * w);
    space.expand(modes.shapes.col(i), dofs);
    for (unsigned int j = 0; j < cells.size(); ++j) {
      const CorotationalBeam &beam = cells[j].beam;
      Vector12 ends_moved;
      for (unsigned int k = 0; k < 12; ++k)
        ends_moved[k] = dofs[cells[j].dofs[k]];
      mode_forces.col(m).segment<7>(7 * j) =
          beam.stiffness() *
          beam.of_motion(beam.deform(ends(cells[j], rest)), beam.length_at_rest(), ends_moved);
    }
    for (unsigned int j = 0; j < scene.springs.size(); ++j)
      for (unsigned int c = 0; c < 6; ++c)
        if (scene.springs[j].stiffness[c] != 0.)
          mode_forces(7 * cells.size() + 6 * j + c, m) =
              scene.springs[j].stiffness[c] * extension(scene.springs[j], c, dofs);
    ++m;
  }
}

void CorotationalCells::add_modal_damping(const Step &step, Balance &balance) const {
  if (mode_damping.size() == 0)
    return;
  // Forces of the modes on all degrees of freedom, halfway.
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(space.n_dofs(), mode_damping.size());
  for (unsigned int j = 0; j < cells.size(); ++j) {
    const CorotationalBeam &beam = cells[j].beam;
    const CorotationalBeam::Deformed mean = beam.deform(ends(cells[j], step.half));
    const Eigen::MatrixXd of_cell =
        beam.derivative(mean, mean.length).transpose() * mode_forces.middleRows<7>(7 * j);
    for (unsigned int k = 0; k < 12; ++k)
      forces.row(cells[j].dofs[k]) += of_cell.row(k);
  }
  for (unsigned int j = 0; j < scene.springs.size(); ++j)
    for (unsigned int c = 0; c < 6; ++c) {
      const Spring &spring = scene.springs[j];
      if (spring.stiffness[c] == 0.)
        continue;
      const auto row = mode_forces.row(7 * cells.size() + 6 * j + c);
      const SpringExtension extension(spring, c, mesh, discretization.vertex_dofs());
      for (std::size_t i = 0; i < extension.dofs.size(); ++i)
        forces.row(extension.dofs[i]) += extension.weights[i] * row;
    }
  const Vector rates = forces.transpose() * step.change / step.duration,
               sizes = mode_damping.cwiseProduct(rates);
  balance.internal += forces * sizes;
  balance.damping += step.duration * rates.dot(sizes);
  if (step.without_stiffness)
    return;
  Eigen::MatrixXd on_unknowns(space.n_unknowns(), mode_damping.size());
  for (int m = 0; m < forces.cols(); ++m)
    on_unknowns.col(m) = space.restrict_forces(forces.col(m));
  const Eigen::MatrixXd tangent =
      2. / step.duration * on_unknowns * mode_damping.asDiagonal() * on_unknowns.transpose();
  balance.stiffness = balance.stiffness + SparseMatrix(tangent.sparseView(1., -1.)); // all entries
}

} // namespace frictionbeam
