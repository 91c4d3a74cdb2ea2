// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/corotational_beam.h"

namespace frictionbeam {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Columns of a matrix on ends in the cell's frame, to those in global axes: times E^T in blocks.
template <typename Matrix>
void from_global(Matrix &matrix, const Matrix3d &axes) {
  for (int block = 0; block < 4; ++block)
    matrix.template middleCols<3>(3 * block) =
        (matrix.template middleCols<3>(3 * block) * axes.transpose()).eval();
}

double twist_of(const Eigen::Quaterniond &turn) {
  const double half = std::atan2(turn.x(), turn.w()); // q and -q are one rotation
  return 2. * (half > EIGEN_PI / 2.    ? half - EIGEN_PI
               : half < -EIGEN_PI / 2. ? half + EIGEN_PI
                                       : half);
}

/// Of twist_of(), by a spin about the fixed axes in which the rotation is.
Vector3d twist_by_spin(const Eigen::Quaterniond &turn) {
  const double x = turn.x(), y = turn.y(), z = turn.z(), w = turn.w(), size = w * w + x * x;
  return {1., (x * y + z * w) / size, (x * z - y * w) / size};
}

} // namespace

CorotationalBeam::CorotationalBeam(const Vector3d &chord, const Matrix3d &axes,
                                   const Matrix12 &stiffness)
    : chord(chord), rest(axes) {
  motions.setZero();
  motions.block<3, 1>(6, 0) = rest.col(0);
  motions.block<3, 3>(3, 1) = rest;
  motions.block<3, 3>(9, 4) = rest;
  K = motions.transpose() * stiffness * motions;
}

CorotationalBeam::Deformed CorotationalBeam::deform(const Ends &ends) const {
  Deformed result;
  result.chord = chord + ends.relative;
  result.length = result.chord.norm();
  result.axes.col(0) = result.chord / result.length;
  const Vector3d carried = (ends.turn[0] + ends.turn[1]) * rest.col(1); // near the second axis
  result.axes.col(2) = result.axes.col(0).cross(carried).normalized();
  result.axes.col(1) = result.axes.col(2).cross(result.axes.col(0));
  double twist = 0.;
  for (const Matrix3d &turn : ends.turn)
    twist += twist_of(Eigen::Quaterniond(Matrix3d(result.axes.transpose() * turn * rest))) / 2.;
  result.axes *= Eigen::AngleAxisd(twist, Vector3d::UnitX()).toRotationMatrix();
  // Not l - l0, for the digits.
  result.d[0] = ends.relative.dot(2. * chord + ends.relative) / (result.length + chord.norm());
  for (int end = 0; end < 2; ++end) {
    const Eigen::Quaterniond turn(Matrix3d(result.axes.transpose() * ends.turn[end] * rest));
    result.d.segment<3>(1 + 3 * end) = rotation_vector(turn);
    result.twist_by_spin[end] = twist_by_spin(turn);
  }
  return result;
}

CorotationalBeam::Matrix3_12 CorotationalBeam::frame_spin(const Deformed &at) const {
  const double l = at.length;
  Matrix3_12 spin = Matrix3_12::Zero();
  spin(1, 2) = 1. / l;
  spin(1, 8) = -1. / l;
  spin(2, 1) = -1. / l;
  spin(2, 7) = 1. / l;
  for (int end = 0; end < 2; ++end) {
    const Vector3d &by = at.twist_by_spin[end];
    spin.block<1, 3>(0, 6 * end + 3) += by.transpose() / 2.;
    spin.row(0) -= (by[1] * spin.row(1) + by[2] * spin.row(2)) / 2.;
  }
  return spin;
}

CorotationalBeam::Matrix7_12 CorotationalBeam::derivative(const Deformed &at,
                                                          const double length) const {
  const Matrix3_12 frame = frame_spin(at);
  Matrix7_12 B = Matrix7_12::Zero();
  for (int end = 0; end < 2; ++end) {
    auto rows = B.middleRows<3>(1 + 3 * end);
    rows = -frame;
    rows.middleCols<3>(6 * end + 3) += Matrix3d::Identity();
    rows = (vector_per_spin(at.d.segment<3>(1 + 3 * end)) * rows).eval();
  }
  from_global(B, at.axes);
  B.block<1, 3>(0, 0) = -at.chord.transpose() / length;
  B.block<1, 3>(0, 6) = at.chord.transpose() / length;
  return B;
}

CorotationalBeam::Matrix12 CorotationalBeam::geometric_stiffness(const Deformed &at,
                                                                 const Vector7 &s) const {
  const Matrix3_12 frame = frame_spin(at);
  const double l = at.length;
  // Moments on spins of the ends relative to E, then what of the forces on the ends they are.
  Vector3d moment[2], sum = Vector3d::Zero();
  Vector12 forces = Vector12::Zero();
  Matrix12 result = Matrix12::Zero();
  Matrix3_12 of_both = Matrix3_12::Zero();
  for (int end = 0; end < 2; ++end) {
    const Vector3d M = s.segment<3>(1 + 3 * end);
    moment[end] = vector_per_spin(at.d.segment<3>(1 + 3 * end)).transpose() * M;
    sum += moment[end];
    forces.segment<3>(6 * end + 3) = moment[end];
    // The moment's own change with the rotation vector, to first order: (e - F)^T S (e - F), e the
    // end's spin, F that of the frame.
    const Matrix3d S = -skew(M) / 2.;
    const Matrix3_12 of_frame = S * frame;
    result.middleRows<3>(6 * end + 3) -= of_frame;
    result.middleCols<3>(6 * end + 3) -= frame.transpose() * S;
    result.block<3, 3>(6 * end + 3, 6 * end + 3) += S;
    of_both += of_frame;
  }
  result += frame.transpose().lazyProduct(of_both);
  forces -= frame.transpose() * sum;
  // The frame turns with all that it carries, and lever arms grow with the chord.
  for (int block = 0; block < 4; ++block)
    result.middleRows<3>(3 * block) -= skew(forces.segment<3>(3 * block)) * frame;
  const Vector12 levers = (frame.row(1) * sum[1] + frame.row(2) * sum[2]).transpose() / l;
  result.col(0) -= levers;
  result.col(6) += levers;
  for (int d = 1; d < 3; ++d)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        result(6 * a + d, 6 * b + d) += (a == b ? s[0] : -s[0]) / l;
  from_global(result, at.axes);
  Matrix12 turned;
  for (int block = 0; block < 4; ++block)
    turned.middleRows<3>(3 * block) = at.axes * result.middleRows<3>(3 * block);
  return turned;
}

} // namespace frictionbeam
