// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line/pipe_element.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/LU>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

PipeElement::PipeElement(const Discretization &discretization)
    : PipeElement(discretization, QGauss<1>(2), QGauss<1>(12)) {}

PipeElement::PipeElement(const Discretization &discretization, const Quadrature<1> &straight,
                         const Quadrature<1> &curved)
    : discretization(discretization),
      straight_values(discretization.elements()[0], straight,
                      update_values | update_gradients | update_JxW_values),
      straight_mass_values(discretization.elements()[0], QGauss<1>(4),
                           update_values | update_JxW_values) {
  const auto &profiles = discretization.profiles();
  if (std::any_of(profiles.begin(), profiles.end(),
                  [](const Profile &profile) { return profile.arc_centre.has_value(); }))
    arc_values = std::make_unique<FEValues<1, 3>>(
        discretization.elements()[1], curved, update_values | update_gradients | update_JxW_values);
}

void PipeElement::reinit(const Discretization::Cell &cell) {
  section = &discretization.profiles()[cell->material_id()];
  bend.reset();
  if (section->arc_centre)
    bend.emplace(cell->vertex(0), cell->vertex(1), section->arc());
  values = bend ? arc_values.get() : &straight_values;
  values->reinit(cell);
  stretch = bend ? bend->length() / (cell->vertex(1) - cell->vertex(0)).norm() : 1.;
  strains.resize(values->n_quadrature_points);
  const LocalAxes axes(cell->vertex(1) - cell->vertex(0));
  for (unsigned int q = 0; q < strains.size(); ++q)
    for (unsigned int i = 0; i < 12; ++i)
      strains[q][i] = bend ? arc_strain(*values, *bend, values->get_quadrature().point(q)[0], i, q)
                           : generalized_strain(*values, axes, i, q);
  const CellJoints *const joints = discretization.joints(cell);
  jointed = joints != nullptr;
  if (jointed)
    add_joints(*joints);
}

void PipeElement::add_joints(const CellJoints &joints) {
  Matrix12 &F = joint_flexibility;
  F.setZero();
  for (unsigned int end = 0; end < 2; ++end)
    for (unsigned int i = 0; i < 6; ++i) {
      pushed[6 * end + i] = joints.thrust[end][i];
      for (unsigned int j = 0; j < 6; ++j)
        F(6 * end + i, 6 * end + j) = joints.flexibility[end][i][j];
    }
  beyond = (Matrix12::Identity() + F * plain_stiffness()).inverse();
}

PipeElement::Matrix12 PipeElement::stiffness() const {
  return jointed ? Matrix12(plain_stiffness() * beyond) : plain_stiffness();
}

PipeElement::Vector12 PipeElement::unit_thrust() const {
  if (!jointed)
    return Vector12::Zero();
  // The ends stand at beyond (u + pushed): forces K beyond pushed are missing for u = 0.
  return -plain_stiffness() * beyond * pushed;
}

Eigen::Matrix<double, 6, 12> PipeElement::strain_matrix(const unsigned int point) const {
  Eigen::Matrix<double, 6, 12> B;
  for (unsigned int i = 0; i < 12; ++i)
    for (unsigned int c = 0; c < 6; ++c)
      B(c, i) = strains[point][i][c];
  return B;
}

double PipeElement::length_at(const unsigned int point) const {
  return stretch * values->JxW(point);
}

Eigen::Matrix<double, 6, 1> PipeElement::curvature_strain(const unsigned int point) const {
  Eigen::Matrix<double, 6, 1> strain = Eigen::Matrix<double, 6, 1>::Zero();
  if (bend) {
    const LocalAxes axes(bend->tangent(bend->angle() * values->get_quadrature().point(point)[0]));
    strain[4] = axes.y * bend->axis();
    strain[5] = axes.z * bend->axis();
  }
  return strain;
}

PipeElement::Matrix12 PipeElement::plain_stiffness() const {
  Matrix12 result = Matrix12::Zero();
  for (unsigned int q = 0; q < strains.size(); ++q) {
    const Eigen::Matrix<double, 6, 12> B = strain_matrix(q);
    const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> D(&section->tangent(0, 0));
    result.noalias() += length_at(q) * (B.transpose() * (D * B).eval());
  }
  return result;
}

Eigen::Matrix<double, 12, 3> PipeElement::unit_line_loads() const {
  Eigen::Matrix<double, 12, 3> result = Eigen::Matrix<double, 12, 3>::Zero();
  for (unsigned int q = 0; q < strains.size(); ++q)
    for (unsigned int i = 0; i < 12; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        result(i, d) += values->shape_value_component(i, q, d) * stretch * values->JxW(q);
  if (jointed)
    return beyond.transpose() * result;
  return result;
}

PipeElement::Vector12 PipeElement::unit_axial_strain() const {
  Vector12 result = Vector12::Zero();
  for (unsigned int q = 0; q < strains.size(); ++q)
    for (unsigned int i = 0; i < 12; ++i)
      result[i] += strains[q][i][0] * section->EA * stretch * values->JxW(q);
  if (jointed)
    return beyond.transpose() * result;
  return result;
}

PipeElement::Vector12 PipeElement::unit_curvature() const {
  Vector12 result = Vector12::Zero();
  if (bend)
    for (unsigned int q = 0; q < strains.size(); ++q)
      result += section->EI * length_at(q) * (strain_matrix(q).transpose() * curvature_strain(q));
  if (jointed)
    return beyond.transpose() * result;
  return result;
}

PipeElement::Matrix12 PipeElement::mass(const Discretization::Cell &cell) {
  reinit(cell);
  if (!bend)
    straight_mass_values.reinit(cell);
  const FEValues<1, 3> &shapes = bend ? *arc_values : straight_mass_values;
  const Profile &profile = *section;
  Vector3 tangent = cell->vertex(1) - cell->vertex(0);
  tangent /= tangent.norm();
  Matrix12 result = Matrix12::Zero();
  for (unsigned int q = 0; q < shapes.n_quadrature_points; ++q) {
    if (bend)
      tangent = bend->tangent(bend->angle() * shapes.get_quadrature().point(q)[0]);
    for (unsigned int i = 0; i < 12; ++i) {
      // Momentum of function i.
      Vector3 rotation;
      for (unsigned int d = 0; d < 3; ++d)
        rotation[d] = shapes.shape_value_component(i, q, 3 + d);
      const Vector3 twist = (rotation * tangent) * tangent,
                    spin =
                        profile.rotary_inertia * (rotation - twist) + profile.twist_inertia * twist;
      for (unsigned int j = 0; j < 12; ++j) {
        double sum = 0.;
        for (unsigned int d = 0; d < 3; ++d)
          sum += profile.mass * shapes.shape_value_component(i, q, d) *
                     shapes.shape_value_component(j, q, d) +
                 spin[d] * shapes.shape_value_component(j, q, 3 + d);
        result(i, j) += sum * stretch * shapes.JxW(q);
      }
    }
  }
  if (jointed)
    return beyond.transpose() * result * beyond;
  return result;
}

} // namespace frictionbeam
