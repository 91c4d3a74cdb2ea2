// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/corotational_line.h"

namespace frictionbeam {

using namespace dealii;
using Eigen::Matrix3d;
using Eigen::Vector3d;

void CorotationalLine::add_mass() {
  for (const PointMass &mass : scene.masses)
    for (const std::string &point : mass.points)
      point_mass[mesh.points.at(point)] += mass.mass;
  M = pattern;
  for (const Cell &cell : cells) {
    std::vector<types::global_dof_index> dofs(cell.dofs.begin(), cell.dofs.begin() + 3);
    dofs.insert(dofs.end(), cell.dofs.begin() + 6, cell.dofs.begin() + 9);
    Eigen::Matrix<double, 6, 6> local = cell.mass / 3. * Eigen::Matrix<double, 6, 6>::Identity();
    local.topRightCorner<3, 3>() = local.bottomLeftCorner<3, 3>() =
        cell.mass / 6. * Matrix3d::Identity();
    add_local(local, dofs, M);
  }
  for (unsigned int v = 0; v < n_vertices; ++v) {
    std::vector<types::global_dof_index> dofs;
    for (unsigned int d = 0; d < 3; ++d)
      dofs.push_back(discretization.vertex_dofs().index(v, d));
    if (point_mass[v] > 0.)
      add_local(point_mass[v] * Matrix3d::Identity(), dofs, M);
  }
}

void CorotationalLine::add_rotary(const Pose &from, const Pose &to, const Vector &change,
                                  const Vector &spin_before, const double step, Vector &forces,
                                  SparseMatrix &matrix) const {
  Vector on_dofs = Vector::Zero(space.n_dofs());
  for (unsigned int v = 0; v < n_vertices; ++v) {
    if (!turns(v) || vertex_inertia[v].isZero(0.))
      continue;
    const Matrix3d before = turn(from, v).toRotationMatrix(),
                   after = turn(to, v).toRotationMatrix();
    const Vector3d vector = part(change, v, 3), spin = part(spin_before, v, 3);
    const Vector3d momentum_before = before * (vertex_inertia[v] * (before.transpose() * spin)),
                   momentum = after * (vertex_inertia[v] *
                                       (before.transpose() * (2. / step * vector - spin)));
    add_part(-2. / step * (momentum - momentum_before), v, 3, on_dofs);
    const Matrix3d derivative = 2. / step *
                                (2. / step * after * vertex_inertia[v] * before.transpose() -
                                 skew(momentum) * cayley_spin(vector));
    std::vector<types::global_dof_index> dofs;
    for (unsigned int d = 0; d < 3; ++d)
      dofs.push_back(discretization.vertex_dofs().index(v, 3 + d));
    add_local(derivative, dofs, matrix);
  }
  forces += space.restrict_forces(on_dofs);
}

void CorotationalLine::set_spins(const Pose &from, const Pose &to, const Vector &change,
                                 const Vector &spin_before, const double step,
                                 Vector &velocity) const {
  for (unsigned int v = 0; v < n_vertices; ++v) {
    if (!turns(v))
      continue;
    Vector3d spin = part(change, v, 3) / step; // without inertia: the mean
    if (!vertex_inertia[v].isZero(0.))
      spin = turn(to, v) * (turn(from, v).conjugate() * (2. * spin - part(spin_before, v, 3)));
    for (unsigned int d = 0; d < 3; ++d)
      for (const auto &term : space.terms(discretization.vertex_dofs().index(v, 3 + d)))
        if (term.weight == 1.)
          velocity[term.unknown] = spin[d];
  }
}

double CorotationalLine::kinetic_energy(const Pose &pose, const Vector &velocity) const {
  double energy = 0.;
  for (const Cell &cell : cells) {
    const Vector3d v0 = part(velocity, cell.vertices[0], 0),
                   v1 = part(velocity, cell.vertices[1], 0);
    energy += cell.mass / 6. * (v0.dot(v0) + v0.dot(v1) + v1.dot(v1));
  }
  for (unsigned int v = 0; v < n_vertices; ++v) {
    const Vector3d spin = turn(pose, v).conjugate() * part(velocity, v, 3);
    energy +=
        (point_mass[v] * part(velocity, v, 0).squaredNorm() + spin.dot(vertex_inertia[v] * spin)) /
        2.;
  }
  return energy;
}

Motion CorotationalLine::momentum(const Pose &pose, const Vector &velocity) const {
  Vector3d linear_sum = Vector3d::Zero(), angular_sum = Vector3d::Zero();
  const auto place = [&](const unsigned int v) {
    const Point3 &rest = discretization.vertices()[v];
    return Vector3d(Vector3d(rest[0], rest[1], rest[2]) + part(pose.dofs, v, 0));
  };
  for (const Cell &cell : cells)
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j) {
        const Vector3d share = cell.mass / (i == j ? 3. : 6.) * part(velocity, cell.vertices[j], 0);
        linear_sum += share;
        angular_sum += place(cell.vertices[i]).cross(share);
      }
  for (unsigned int v = 0; v < n_vertices; ++v) {
    const Vector3d share = point_mass[v] * part(velocity, v, 0),
                   spin = turn(pose, v).conjugate() * part(velocity, v, 3);
    linear_sum += share;
    angular_sum += place(v).cross(share) + turn(pose, v) * (vertex_inertia[v] * spin);
  }
  return {linear_sum[0],  linear_sum[1],  linear_sum[2],
          angular_sum[0], angular_sum[1], angular_sum[2]};
}

} // namespace frictionbeam
