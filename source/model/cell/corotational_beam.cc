// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/corotational_beam.h"

namespace frictionbeam {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

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

CorotationalBeam::Matrix3_9 CorotationalBeam::frame_spin(const Deformed &at) const {
  const Vector3d twist = (at.twist_by_spin[0] + at.twist_by_spin[1]) / (2. * at.length);
  Matrix3_9 spin = Matrix3_9::Zero();
  spin(0, 1) = -twist[2];
  spin(0, 2) = twist[1];
  spin(1, 2) = -1. / at.length;
  spin(2, 1) = 1. / at.length;
  spin.block<1, 3>(0, 3) = at.twist_by_spin[0].transpose() / 2.;
  spin.block<1, 3>(0, 6) = at.twist_by_spin[1].transpose() / 2.;
  return spin;
}

CorotationalBeam::Matrix7_9 CorotationalBeam::derivative_by_relative(const Deformed &at,
                                                                     const double length) const {
  const Matrix3_9 frame = frame_spin(at);
  Matrix7_9 B;
  B.row(0) << at.chord.transpose() / length, Eigen::Matrix<double, 1, 6>::Zero();
  for (int end = 0; end < 2; ++end) {
    const Matrix3d by_spin = vector_per_spin(at.d.segment<3>(1 + 3 * end));
    for (int block = 0; block < 3; ++block) {
      Matrix3d in_frame = block == 1 + end ? by_spin : Matrix3d(Matrix3d::Zero());
      if (block == 0) // the frame's spin has no more than these
        for (int i = 1; i < 3; ++i)
          in_frame.col(i) = -frame(0, i) * by_spin.col(0) - frame(3 - i, i) * by_spin.col(3 - i);
      else
        for (int i = 0; i < 3; ++i)
          in_frame.col(i) -= frame(0, 3 * block + i) * by_spin.col(0);
      B.block<3, 3>(1 + 3 * end, 3 * block).noalias() = in_frame * at.axes.transpose();
    }
  }
  return B;
}

CorotationalBeam::Matrix7_12 CorotationalBeam::derivative(const Deformed &at,
                                                          const double length) const {
  const Matrix7_9 by_relative = derivative_by_relative(at, length);
  Matrix7_12 B;
  B << -by_relative.leftCols<3>(), by_relative.middleCols<3>(3), by_relative.leftCols<3>(),
      by_relative.rightCols<3>();
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

CorotationalBeam::Matrix9 CorotationalBeam::geometric_stiffness(const Deformed &at,
                                                                const Vector7 &s) const {
  const Matrix3_9 frame = frame_spin(at);
  // Moments on spins of the ends relative to E, then what of the forces they are.
  Vector3d moment[2];
  Matrix3d S[2];
  for (int end = 0; end < 2; ++end) {
    const Vector3d M = s.segment<3>(1 + 3 * end);
    moment[end] = transposed_vector_per_spin(at.d.segment<3>(1 + 3 * end), M);
    S[end] = -skew(M) / 2.;
  }
  const Vector3d sum = moment[0] + moment[1];
  // A moment's own change with the rotation vector, to first order: (e - F)^T S (e - F), e the
  // end's spin, F that of the frame; and the frame turns with all that it carries.
  Matrix9 result = Matrix9::Zero();
  Eigen::Matrix<double, 9, 3> by_frame = frame.transpose().lazyProduct(S[0] + S[1]);
  for (int end = 0; end < 2; ++end) {
    const int spins = 3 + 3 * end;
    result.middleCols<3>(spins) = -frame.transpose().lazyProduct(S[end]);
    result.block<3, 3>(spins, spins) += S[end];
    by_frame.middleRows<3>(spins) -=
        S[end] + skew(moment[end] - sum[0] / 2. * at.twist_by_spin[end]);
  }
  by_frame.topRows<3>() += skew(frame.leftCols<3>().transpose() * sum);
  for (int i = 1; i < 3; ++i) // the frame's spin has no more than these
    result.col(i) += frame(0, i) * by_frame.col(0) + frame(3 - i, i) * by_frame.col(3 - i);
  for (int i = 3; i < 9; ++i)
    result.col(i) += frame(0, i) * by_frame.col(0);
  // Lever arms grow with the chord.
  const double l = at.length;
  result(1, 0) += sum[2] / (l * l);
  result(2, 0) -= sum[1] / (l * l);
  result(1, 1) += s[0] / l;
  result(2, 2) += s[0] / l;
  Matrix9 turned;
  for (int i = 0; i < 9; i += 3)
    for (int j = 0; j < 9; j += 3) {
      const Matrix3d columns = result.block<3, 3>(i, j) * at.axes.transpose();
      turned.block<3, 3>(i, j).noalias() = at.axes * columns;
    }
  return turned;
}

CorotationalBeam::Matrix12 CorotationalBeam::of_ends(const Matrix9 &by_relative) {
  constexpr int blocks[4] = {0, 3, 0, 6};
  constexpr double signs[4] = {-1., 1., 1., 1.};
  Matrix12 result;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      result.block<3, 3>(3 * i, 3 * j) =
          signs[i] * signs[j] * by_relative.block<3, 3>(blocks[i], blocks[j]);
  return result;
}

} // namespace frictionbeam
