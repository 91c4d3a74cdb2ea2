// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "path.h"

#include <array>

/**
 * @file
 * One piece of pipe by the unit-force method, with its integrals by numerical quadrature. Numbers
 * are long double, so that what differs from the program is not rounding of the oracle.
 */
namespace oracle {

using Real = long double;
using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Vec6 = Eigen::Matrix<Real, 6, 1>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;
using Mat6 = Eigen::Matrix<Real, 6, 6>;
using Vec12 = Eigen::Matrix<Real, 12, 1>;
using Mat12 = Eigen::Matrix<Real, 12, 12>;

/// What a load does to a piece of pipe, along its whole length.
struct MemberLoad {
  Vec3 line_force = Vec3::Zero(); ///< [N/m]
  Vec3 wind = Vec3::Zero();       ///< dynamic pressure times shape factor times diameter [N/m]
  Real strain = 0., curvature = 0., pressure = 0.;

  /// q C D |w| w, w the part of the wind's unit vector across the pipe, with all other forces.
  Vec3 force(const Vec3 &tangent) const;
};

/**
 * A straight or circular piece of constant section from its end a to its end b, with an elastic
 * joint at either end. Clamped at a, a force P and a moment M at b put the section force
 *   S(s) = (P, M + (r_b - r_s) x P) = H(s) (P, M)
 * on the section at s. With the flexibility c of the section and the free strain e (stretch,
 * curvature), the motion of b is, by the unit-force method,
 *   d_b = integral of H^T (c S + e) ds + H_a^T (J_a S_a + j_a) + J_b S_b + j_b = F (P, M) + d_free.
 * So (P, M) = F^-1 (d_b - R d_a - d_free), with R d_a what b does if a moves and nothing bends, and
 * equilibrium gives the force at a.
 */
class Member {
public:
  Curve curve;
  int pipe = 0;
  double start = 0.;                       ///< of its end a along the pipe [m]
  std::array<int, 2> node{};               ///< a, b
  std::array<Vec, 2> tangent{};            ///< of the pipe there: of a bend, not of its chord
  double bend_radius = 0.;                 ///< of the pipe; of a chord, too
  Vec bend_axis = Vec::Zero();             ///< about which the bend turns
  Real EA = 0., GA = 0., GJ = 0., EI = 0.; ///< GA = 0: no shear flexibility; EI with a bend's
  Real mass = 0.;                          ///< per length
  Real rotary = 0., twist = 0.;            ///< per length: about a diameter, about the axis
  std::array<Mat6, 2> joint{{Mat6::Zero(), Mat6::Zero()}};  ///< flexibility, global axes
  std::array<Vec6, 2> thrust{{Vec6::Zero(), Vec6::Zero()}}; ///< of a joint by unit pressure

  void prepare();                                  ///< after everything above is set
  const Mat12 &stiffness() const { return K; }     ///< forces on the ends by motions of the nodes
  Vec12 load_vector(const MemberLoad &load) const; ///< forces on the nodes
  Mat12 mass_matrix() const;                       ///< consistent, with rotary inertia

  /// Force of what follows on what is before the section at s, and the section's motion, under the
  /// nodes' motions @p d and @p load.
  struct At {
    Vec6 force, motion;
  };
  At at(double s, const Vec12 &d, const MemberLoad &load) const;

private:
  Mat6 carry(double from, double to) const;            ///< a force at `to` as one at `from`
  Mat6 compliance(double s) const;                     ///< of a section, global axes
  Vec6 beyond(double s, const MemberLoad &load) const; ///< section force of the loads after s
  Vec6 free_strain(double s, const MemberLoad &load) const;
  Vec6 free_motion(const MemberLoad &load) const;
  Vec12 shape_forces(const Vec6 &at_b) const; ///< the forces at both ends

  Mat6 stiff_b;
  Mat12 K;
};

} // namespace oracle
