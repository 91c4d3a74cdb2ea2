// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/corotational_cells.h"

namespace frictionbeam {

using namespace dealii;
using Eigen::Matrix3d;
using Eigen::Vector3d;

void CorotationalCells::add_mass() {
  M = linear.mass();
  std::fill(M.valuePtr(), M.valuePtr() + M.nonZeros(), 0.);
  for (const Cell &cell : cells) {
    std::vector<types::global_dof_index> dofs(cell.dofs.begin(), cell.dofs.begin() + 3);
    dofs.insert(dofs.end(), cell.dofs.begin() + 6, cell.dofs.begin() + 9);
    Eigen::Matrix<double, 6, 6> local = cell.mass / 3. * Eigen::Matrix<double, 6, 6>::Identity();
    local.topRightCorner<3, 3>() = local.bottomLeftCorner<3, 3>() =
        cell.mass / 6. * Matrix3d::Identity();
    space.add_local(local, dofs, M);
  }
  for (unsigned int v = 0; v < n_vertices; ++v) {
    std::vector<types::global_dof_index> dofs;
    for (unsigned int d = 0; d < 3; ++d)
      dofs.push_back(discretization.vertex_dofs().index(v, d));
    if (point_mass[v] > 0.)
      space.add_local(point_mass[v] * Matrix3d::Identity(), dofs, M);
  }
}

std::vector<types::global_dof_index>
CorotationalCells::rotations_of(const unsigned int vertex) const {
  const VertexDofs &dofs = discretization.vertex_dofs();
  return {dofs.index(vertex, 3), dofs.index(vertex, 4), dofs.index(vertex, 5)};
}

void CorotationalCells::add_rotary(const Pose &from, const Pose &to, const Vector &change,
                                   const Vector &spin_before, const double step, Vector &forces,
                                   SparseMatrix *const matrix) const {
  Vector on_dofs = Vector::Zero(space.n_dofs());
  const double lost = scene.time.mass_damping * step / 2.; // part of the momentum
  for (unsigned int v = 0; v < n_vertices; ++v) {
    if (!turns(v) || vertex_inertia[v].isZero(0.))
      continue;
    const Matrix3d before = turn(from, v).toRotationMatrix(),
                   after = turn(to, v).toRotationMatrix();
    const Vector3d vector = part(change, v, 3), spin = part(spin_before, v, 3);
    const Vector3d momentum_before = before * (vertex_inertia[v] * (before.transpose() * spin)),
                   momentum = after * (vertex_inertia[v] *
                                       (before.transpose() * (2. / step * vector - spin)));
    add_part(-2. / step * ((1. + lost) * momentum - (1. - lost) * momentum_before), v, 3, on_dofs);
    if (matrix == nullptr)
      continue;
    const Matrix3d derivative = 2. / step * (1. + lost) *
                                (2. / step * after * vertex_inertia[v] * before.transpose() -
                                 skew(momentum) * cayley_spin(vector));
    space.add_local(derivative, rotations_of(v), *matrix);
  }
  forces += space.restrict_forces(on_dofs);
}

void CorotationalCells::set_spins(const Pose &from, const Pose &to, const Vector &change,
                                  const Vector &spin_before, const double step,
                                  Vector &velocity) const {
  for (unsigned int v = 0; v < n_vertices; ++v) {
    if (!turns(v))
      continue;
    const Vector3d mean = part(change, v, 3) / step,
                   gained = turn(from, v).conjugate() * (mean - part(spin_before, v, 3)),
                   spin = mean + turn(to, v) * (inert[v] * gained); // without inertia: the mean
    for (unsigned int d = 0; d < 3; ++d)
      for (const auto &term : space.terms(discretization.vertex_dofs().index(v, 3 + d)))
        if (term.weight == 1.)
          velocity[term.unknown] = spin[d];
  }
}

void CorotationalCells::add_rotary_at(const Pose &pose, const Turning &turning, Vector &forces,
                                      SparseMatrix *const matrix) const {
  Vector on_dofs = Vector::Zero(space.n_dofs());
  for (unsigned int v = 0; v < n_vertices; ++v) {
    if (!turns(v) || vertex_inertia[v].isZero(0.))
      continue;
    const Matrix3d rotation = turn(pose, v).toRotationMatrix(),
                   inertia = rotation * vertex_inertia[v] * rotation.transpose();
    const Vector3d spin = part(turning.spin, v, 3), momentum = inertia * spin,
                   acceleration = part(turning.acceleration, v, 3),
                   driving = inertia * acceleration;
    add_part(-(driving + spin.cross(momentum) + turning.damping * momentum), v, 3, on_dofs);
    if (matrix == nullptr)
      continue;
    // By a spin d of the pose J changes by [d]x J - J [d]x.
    const Matrix3d of_turned = vector_per_spin(part(turning.turned, v, 3)),
                   of_spin = turning.spin_per_turn * of_turned,
                   of_driving = inertia * skew(acceleration) - skew(driving) +
                                turning.acceleration_per_turn * inertia * of_turned,
                   of_momentum = inertia * skew(spin) - skew(momentum) + inertia * of_spin;
    space.add_local(of_driving + skew(spin) * of_momentum - skew(momentum) * of_spin +
                        turning.damping * of_momentum,
                    rotations_of(v), *matrix);
  }
  forces += space.restrict_forces(on_dofs);
}

void CorotationalCells::add_rotary_mass(const Pose &pose, SparseMatrix &matrix) const {
  for (unsigned int v = 0; v < n_vertices; ++v)
    if (turns(v)) {
      const Matrix3d rotation = turn(pose, v).toRotationMatrix();
      space.add_local(rotation * (vertex_inertia[v] + Matrix3d::Identity() - inert[v]) *
                          rotation.transpose(),
                      rotations_of(v), matrix);
    }
}

void CorotationalCells::keep_inert(const Pose &pose, const Vector &mean, Vector &rates) const {
  for (unsigned int v = 0; v < n_vertices; ++v)
    if (turns(v)) {
      const Vector3d off = turn(pose, v).conjugate() * (part(mean, v, 3) - part(rates, v, 3));
      add_part(turn(pose, v) * (off - inert[v] * off), v, 3, rates);
    }
}

Vector CorotationalCells::momenta(const Pose &pose, const Vector &velocity) const {
  Vector result = Vector::Zero(velocity.size());
  for (const Cell &cell : cells) {
    const Vector3d first = part(velocity, cell.vertices[0], 0),
                   last = part(velocity, cell.vertices[1], 0);
    add_part(cell.mass / 6. * (2. * first + last), cell.vertices[0], 0, result);
    add_part(cell.mass / 6. * (first + 2. * last), cell.vertices[1], 0, result);
  }
  for (unsigned int v = 0; v < n_vertices; ++v) {
    const Vector3d spin = turn(pose, v).conjugate() * part(velocity, v, 3);
    add_part(point_mass[v] * part(velocity, v, 0), v, 0, result);
    add_part(turn(pose, v) * (vertex_inertia[v] * spin), v, 3, result);
  }
  return result;
}

LineCells::Matrix12 CorotationalCells::mass_of(const unsigned int cell, PipeElement &) const {
  Matrix12 result = Matrix12::Zero();
  for (unsigned int d = 0; d < 3; ++d) {
    result(d, d) = result(6 + d, 6 + d) = cells[cell].mass / 3.;
    result(d, 6 + d) = result(6 + d, d) = cells[cell].mass / 6.;
  }
  return result;
}

} // namespace frictionbeam
