// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line/pipe_element.h"

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/LU>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

Eigen::Matrix3d local_axes(const Discretization::Cell &cell) {
  const LocalAxes axes(cell->vertex(1) - cell->vertex(0));
  Eigen::Matrix3d result;
  for (unsigned int d = 0; d < 3; ++d)
    result.row(d) << axes.x[d], axes.y[d], axes.z[d];
  return result;
}

namespace {

constexpr std::size_t most_kept = 2000; ///< of some 3 kB

/// A matrix on the motions of two vertices, from axes that are the columns of @p axes.
PipeElement::Matrix12 turned(const PipeElement::Matrix12 &matrix, const Eigen::Matrix3d &axes) {
  PipeElement::Matrix12 result;
  for (int row = 0; row < 12; row += 3)
    for (int column = 0; column < 12; column += 3)
      result.block<3, 3>(row, column).noalias() =
          axes * (matrix.block<3, 3>(row, column) * axes.transpose()).eval();
  return result;
}

/// The same of what else a cell has, but its mass.
CellMatrices turned_matrices(const CellMatrices &from, const Eigen::Matrix3d &axes) {
  CellMatrices result;
  result.stiffness = turned(from.stiffness, axes);
  for (int row = 0; row < 12; row += 3) {
    result.line_loads.middleRows<3>(row).noalias() =
        axes * (from.line_loads.middleRows<3>(row) * axes.transpose()).eval();
    result.axial_strain.segment<3>(row).noalias() = axes * from.axial_strain.segment<3>(row);
    result.curvature.segment<3>(row).noalias() = axes * from.curvature.segment<3>(row);
  }
  return result;
}

} // namespace

PipeElement::PipeElement(const Discretization &discretization)
    : PipeElement(discretization, QGauss<1>(2), QGauss<1>(12), true) {}

PipeElement::PipeElement(const Discretization &discretization, const Quadrature<1> &straight,
                         const Quadrature<1> &curved)
    : PipeElement(discretization, straight, curved, false) {}

PipeElement::PipeElement(const Discretization &discretization, const Quadrature<1> &straight,
                         const Quadrature<1> &curved, const bool takes_like)
    : discretization(discretization),
      straight_values(discretization.elements()[0], straight,
                      update_values | update_gradients | update_JxW_values),
      straight_mass_values(discretization.elements()[0], QGauss<1>(4),
                           update_values | update_JxW_values),
      takes_like(takes_like) {
  const auto &profiles = discretization.profiles();
  if (std::any_of(profiles.begin(), profiles.end(),
                  [](const Profile &profile) { return profile.arc_centre.has_value(); }))
    arc_values = std::make_unique<FEValues<1, 3>>(
        discretization.elements()[1], curved, update_values | update_gradients | update_JxW_values);
}

void PipeElement::begin(const Discretization::Cell &cell) {
  section = &discretization.profiles()[cell->material_id()];
  bend.reset();
  if (section->arc_centre)
    bend.emplace(cell->vertex(0), cell->vertex(1), section->arc());
  chord = cell->vertex(1) - cell->vertex(0);
  stretch = bend ? bend->length() / chord.norm() : 1.;
  const PipeCell &piece = discretization.pipe_cells()[discretization.info(cell).index];
  bend_axis = (piece.reversed ? -1. : 1.) * section->bend_axis;
}

void PipeElement::reinit_points(const Discretization::Cell &cell) {
  begin(cell);
  evaluate(cell);
}

void PipeElement::reinit(const Discretization::Cell &cell) {
  begin(cell);
  const CellJoints *const joints = discretization.joints(cell);
  jointed = joints != nullptr;
  if (takes_like && !jointed) {
    take_like(cell);
    bend_piece();
    return;
  }
  like = nullptr;
  evaluate(cell);
  plain = integrate();
  bend_piece();
  if (jointed)
    add_joints(cell, *joints);
}

void PipeElement::bend_piece() {
  if (bend)
    return;
  for (unsigned int d = 0; d < 3; ++d) {
    plain.curvature[3 + d] = -section->EI * bend_axis[d];
    plain.curvature[9 + d] = section->EI * bend_axis[d];
  }
}

Discretization::Cell PipeElement::like_cell(const Discretization::Cell &cell) const {
  return bend ? cell : discretization.like(cell);
}

void PipeElement::take_like(const Discretization::Cell &cell) {
  const Discretization::Cell first = like_cell(cell);
  const Eigen::Matrix3d own_axes = local_axes(cell);
  KeptMatrices &kept = discretization.kept_matrices();
  const auto found = kept.find(first->active_cell_index());
  if (found != kept.end() && &found->second == like && own_axes == cell_axes)
    return;
  like = found == kept.end() ? nullptr : &found->second;
  cell_axes = own_axes;
  if (like == nullptr) {
    evaluate(first);
    like = kept.size() < most_kept ? &kept[first->active_cell_index()] : &not_kept;
    *like = turned_matrices(integrate(), local_axes(first).transpose());
  }
  plain = turned_matrices(*like, cell_axes);
}

void PipeElement::evaluate(const Discretization::Cell &cell) {
  values = bend ? arc_values.get() : &straight_values;
  values->reinit(cell);
  strains.resize(values->n_quadrature_points);
  const LocalAxes local(cell->vertex(1) - cell->vertex(0));
  for (unsigned int q = 0; q < strains.size(); ++q) {
    if (bend) {
      const ArcPoint point(*bend, place_of(q));
      for (unsigned int i = 0; i < 12; ++i)
        strains[q][i] = arc_strain(*values, point, i, q);
    } else
      for (unsigned int i = 0; i < 12; ++i)
        strains[q][i] = generalized_strain(*values, local, i, q);
  }
}

void PipeElement::add_joints(const Discretization::Cell &cell, const CellJoints &joints) {
  Matrix12 &F = joint_flexibility;
  F.setZero();
  for (unsigned int end = 0; end < 2; ++end)
    for (unsigned int i = 0; i < 6; ++i) {
      pushed[6 * end + i] = joints.thrust[end][i];
      for (unsigned int j = 0; j < 6; ++j)
        F(6 * end + i, 6 * end + j) = joints.flexibility[end][i][j];
    }
  // In local axes, where what a soft joint yields to stands apart from what the pipe is stiff
  // against: in others rounding grows by F K, the one beside the other.
  const Eigen::Matrix3d axes = local_axes(cell), back = axes.transpose();
  const Matrix12 K = turned(plain.stiffness, back);
  const Matrix12 local_beyond = (Matrix12::Identity() + turned(F, back) * K).inverse();
  beyond = turned(local_beyond, axes);
  jointed_stiffness = turned(K * local_beyond, axes);
}

const PipeElement::Matrix12 &PipeElement::stiffness() const {
  return jointed ? jointed_stiffness : plain.stiffness;
}

PipeElement::Vector12 PipeElement::unit_thrust() const {
  if (!jointed)
    return Vector12::Zero();
  // The ends stand at beyond (u + pushed): forces K beyond pushed are missing for u = 0.
  return -jointed_stiffness * pushed;
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
  } else {
    const LocalAxes axes(chord);
    strain[4] = axes.y * bend_axis;
    strain[5] = axes.z * bend_axis;
  }
  return strain;
}

CellMatrices PipeElement::integrate() const {
  const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> D(&section->tangent(0, 0));
  CellMatrices result;
  result.stiffness.setZero();
  result.line_loads.setZero();
  result.axial_strain.setZero();
  result.curvature.setZero();
  for (unsigned int q = 0; q < strains.size(); ++q) {
    const Eigen::Matrix<double, 6, 12> B = strain_matrix(q);
    result.stiffness.noalias() += length_at(q) * (B.transpose() * (D * B).eval());
    for (unsigned int i = 0; i < 12; ++i) {
      for (unsigned int d = 0; d < 3; ++d)
        result.line_loads(i, d) += values->shape_value_component(i, q, d) * length_at(q);
      result.axial_strain[i] += strains[q][i][0] * section->EA * length_at(q);
    }
    if (bend)
      result.curvature += section->EI * length_at(q) * (B.transpose() * curvature_strain(q));
  }
  return result;
}

Eigen::Matrix<double, 12, 3> PipeElement::unit_line_loads() const {
  return jointed ? (beyond.transpose() * plain.line_loads).eval() : plain.line_loads;
}

PipeElement::Vector12 PipeElement::unit_axial_strain() const {
  return jointed ? Vector12(beyond.transpose() * plain.axial_strain) : plain.axial_strain;
}

PipeElement::Vector12 PipeElement::unit_curvature() const {
  return jointed ? Vector12(beyond.transpose() * plain.curvature) : plain.curvature;
}

PipeElement::Matrix12 PipeElement::mass(const Discretization::Cell &cell) {
  reinit(cell);
  if (!plain.mass && like != nullptr) {
    if (!like->mass) {
      const Discretization::Cell first = like_cell(cell);
      like->mass = turned(integrate_mass(first), local_axes(first).transpose());
    }
    plain.mass = turned(*like->mass, cell_axes);
  }
  if (!plain.mass)
    plain.mass = integrate_mass(cell);
  return jointed ? Matrix12(beyond.transpose() * *plain.mass * beyond) : *plain.mass;
}

PipeElement::Matrix12 PipeElement::integrate_mass(const Discretization::Cell &cell) {
  FEValues<1, 3> &shapes = bend ? *arc_values : straight_mass_values;
  shapes.reinit(cell);
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
  return result;
}

} // namespace frictionbeam
