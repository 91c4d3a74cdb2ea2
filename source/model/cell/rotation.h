// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

/**
 * @file
 * Finite rotations in space, as unit quaternions. A spin w changes a rotation R to (1 + [w]x) R.
 */
namespace frictionbeam {

/// [v]x, so that [v]x a = v x a.
inline Eigen::Matrix3d skew(const Eigen::Vector3d &v) {
  Eigen::Matrix3d result;
  result << 0., -v[2], v[1], v[2], 0., -v[0], -v[1], v[0], 0.;
  return result;
}

/// The rotation with a rotation vector, angle times axis.
inline Eigen::Quaterniond turn_by(const Eigen::Vector3d &vector) {
  const double half = vector.norm() / 2., scale = half > 1e-8 ? std::sin(half) / half / 2. : 0.5;
  Eigen::Quaterniond result;
  result.w() = std::cos(half);
  result.vec() = scale * vector;
  return result.normalized();
}

/// The rotation with a Cayley vector, 2 tan(angle/2) times axis: what rigid motion over a time step
/// makes of its mean angular velocity, x1 - x0 = vector x (x0 + x1)/2.
inline Eigen::Quaterniond cayley(const Eigen::Vector3d &vector) {
  Eigen::Quaterniond result;
  result.w() = 1.;
  result.vec() = vector / 2.;
  return result.normalized();
}

/// Cayley vector of a rotation of less than pi.
inline Eigen::Vector3d cayley_vector(const Eigen::Quaterniond &rotation) {
  return 2. / rotation.w() * rotation.vec();
}

/// Spin of the rotation per change of its Cayley vector.
inline Eigen::Matrix3d cayley_spin(const Eigen::Vector3d &vector) {
  return (Eigen::Matrix3d::Identity() + skew(vector / 2.)) / (1. + vector.squaredNorm() / 4.);
}

/// Half of a rotation of less than pi.
inline Eigen::Quaterniond half_of(Eigen::Quaterniond rotation) {
  if (rotation.w() < 0.)
    rotation.coeffs() *= -1.;
  rotation.w() += 1.;
  return rotation.normalized();
}

/// Rotation vector, of at most pi.
inline Eigen::Vector3d rotation_vector(const Eigen::Quaterniond &rotation) {
  const double sine = rotation.vec().norm(), sign = rotation.w() < 0. ? -1. : 1.;
  const double scale = sine > 1e-10 ? 2. * std::atan2(sine, std::abs(rotation.w())) / sine : 2.;
  return sign * scale * rotation.vec();
}

/// Of the rotation vectors of a rotation, which differ by whole turns, the nearest to another one.
inline Eigen::Vector3d rotation_vector_near(const Eigen::Quaterniond &rotation,
                                            const Eigen::Vector3d &near) {
  constexpr double whole_turn = 6.283185307179586477;
  const Eigen::Vector3d least = rotation_vector(rotation);
  const double angle = least.norm();
  if (angle < 1e-12) {
    const double size = near.norm();
    return size > 3.
               ? Eigen::Vector3d(least + std::round(size / whole_turn) * whole_turn / size * near)
               : least;
  }
  const Eigen::Vector3d axis = least / angle;
  return (angle + whole_turn * std::round((near.dot(axis) - angle) / whole_turn)) * axis;
}

/// (1 - x cot x)/(2 x)^2 with x half the angle, given its square; by its series where digits
/// cancel.
inline double second_of_vector_per_spin(const double square) {
  if (square < 0.01) // the next term is below 1e-17 of the first
    return (1. + square / 60. * (1. + square / 42. * (1. + square / 40. * (1. + square / 39.6)))) /
           12.;
  const double half = std::sqrt(square) / 2.;
  return (1. - half / std::tan(half)) / square;
}

/// Change of the rotation vector per spin of the rotation.
inline Eigen::Matrix3d vector_per_spin(const Eigen::Vector3d &vector) {
  const Eigen::Matrix3d cross = skew(vector);
  return Eigen::Matrix3d::Identity() - cross / 2. +
         second_of_vector_per_spin(vector.squaredNorm()) * cross * cross;
}

/// vector_per_spin(vector) v, and the transposed matrix times v.
inline Eigen::Vector3d times_vector_per_spin(const Eigen::Vector3d &vector,
                                             const Eigen::Vector3d &v) {
  const Eigen::Vector3d once = vector.cross(v);
  return v - once / 2. + second_of_vector_per_spin(vector.squaredNorm()) * vector.cross(once);
}
inline Eigen::Vector3d transposed_vector_per_spin(const Eigen::Vector3d &vector,
                                                  const Eigen::Vector3d &v) {
  const Eigen::Vector3d once = vector.cross(v);
  return v + once / 2. + second_of_vector_per_spin(vector.squaredNorm()) * vector.cross(once);
}

} // namespace frictionbeam
