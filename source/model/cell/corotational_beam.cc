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

/// Cosine and sine of an angle and of its half, which is of at most pi/2.
struct Angle {
  double cosine = 1., sine = 0., cosine_of_half = 1., sine_of_half = 0.;
};

/// The mean of the twists 2 atan(q_x/q_w) of two rotations; q and -q are one.
Angle mean_twist(const Eigen::Quaterniond &one, const Eigen::Quaterniond &other) {
  // The sum of their halves, as the argument of a product of complex numbers.
  const double w[2] = {std::abs(one.w()), std::abs(other.w())},
               x[2] = {one.w() < 0. ? -one.x() : one.x(), other.w() < 0. ? -other.x() : other.x()};
  const double real = w[0] * w[1] - x[0] * x[1], imaginary = w[0] * x[1] + x[0] * w[1],
               size = std::sqrt(real * real + imaginary * imaginary);
  Angle angle;
  if (size == 0.)
    return angle;
  angle.cosine = real / size;
  angle.sine = imaginary / size;
  if (real >= 0.) {
    angle.cosine_of_half = std::sqrt((1. + angle.cosine) / 2.);
    angle.sine_of_half = angle.sine / (2. * angle.cosine_of_half);
  } else {
    angle.sine_of_half = std::copysign(std::sqrt((1. - angle.cosine) / 2.), angle.sine);
    angle.cosine_of_half = angle.sine / (2. * angle.sine_of_half);
  }
  return angle;
}

/// Change of the twist 2 atan(q_x/q_w) by a spin about the fixed axes in which the rotation is.
Vector3d twist_by_spin(const Eigen::Quaterniond &turn) {
  const double x = turn.x(), y = turn.y(), z = turn.z(), w = turn.w(), size = w * w + x * x;
  return {1., (x * y + z * w) / size, (x * z - y * w) / size};
}

} // namespace

CorotationalBeam::CorotationalBeam(const Vector3d &chord, const Matrix3d &axes,
                                   const Matrix12 &stiffness)
    : chord(chord), rest(axes), rest_turn(axes) {
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
  const Vector3d across = rest.col(1),
                 carried = ends.turn[0] * across + ends.turn[1] * across; // near the second axis
  result.axes.col(2) = result.axes.col(0).cross(carried).normalized();
  result.axes.col(1) = result.axes.col(2).cross(result.axes.col(0));
  const Eigen::Quaterniond back = Eigen::Quaterniond(result.axes).conjugate();
  Eigen::Quaterniond turns[2] = {back * ends.turn[0] * rest_turn, back * ends.turn[1] * rest_turn};
  const Angle twist = mean_twist(turns[0], turns[1]);
  const Vector3d second = result.axes.col(1), third = result.axes.col(2);
  result.axes.col(1) = twist.cosine * second + twist.sine * third;
  result.axes.col(2) = twist.cosine * third - twist.sine * second;
  const Eigen::Quaterniond twisted_back(twist.cosine_of_half, -twist.sine_of_half, 0., 0.);
  // Not l - l0, for the digits.
  result.d[0] = ends.relative.dot(2. * chord + ends.relative) / (result.length + chord.norm());
  for (int end = 0; end < 2; ++end) {
    const Eigen::Quaterniond turn = twisted_back * turns[end];
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

CorotationalBeam::Vector12 CorotationalBeam::on_ends(const Deformed &at, const double length,
                                                     const Vector7 &s) const {
  // In E: moments on spins of the ends relative to the frame, less what the frame's spin makes of
  // them (frame_spin()).
  Vector3d moment[2], twist = Vector3d::Zero();
  for (int end = 0; end < 2; ++end) {
    moment[end] =
        transposed_vector_per_spin(at.d.segment<3>(1 + 3 * end), s.segment<3>(1 + 3 * end));
    twist += at.twist_by_spin[end] / 2.;
  }
  const Vector3d sum = moment[0] + moment[1];
  const Vector3d across(0., (sum[2] - twist[2] * sum[0]) / at.length,
                        -(sum[1] - twist[1] * sum[0]) / at.length);
  const Vector3d force = at.axes * across - s[0] / length * at.chord;
  Vector12 result;
  result << force, at.axes * (moment[0] - sum[0] / 2. * at.twist_by_spin[0]), -force,
      at.axes * (moment[1] - sum[0] / 2. * at.twist_by_spin[1]);
  return result;
}

CorotationalBeam::Vector7 CorotationalBeam::of_motion(const Deformed &at, const double length,
                                                      const Vector12 &motion) const {
  const Vector3d relative = motion.segment<3>(6) - motion.head<3>(),
                 across = at.axes.transpose() * relative / at.length;
  Vector3d spin[2], frame(0., -across[2], across[1]);
  for (int end = 0; end < 2; ++end) {
    spin[end] = at.axes.transpose() * motion.segment<3>(6 * end + 3);
    const Vector3d &by = at.twist_by_spin[end];
    frame[0] += (by.dot(spin[end]) + by[1] * across[2] - by[2] * across[1]) / 2.;
  }
  Vector7 result;
  result << at.chord.dot(relative) / length,
      times_vector_per_spin(at.d.segment<3>(1), spin[0] - frame),
      times_vector_per_spin(at.d.segment<3>(4), spin[1] - frame);
  return result;
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
