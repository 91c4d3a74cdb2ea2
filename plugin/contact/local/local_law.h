// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/local_problem.h>

#include <limits>
#include <vector>

namespace frictionbeam::contact {

/// What the reactions of all contacts are projected to, z_N on z_N >= 0, then z_T on the disc of
/// radius mu max(0, z_N), with derivatives.
struct LawProjection {
  Eigen::VectorXd point;
  std::vector<Eigen::Matrix3d> derivative; ///< d point / d z of each contact, its first rows
  std::vector<int> state;                  ///< 0 open, 1 sticks, 2 slips

  void project(const LocalProblem &problem, const Eigen::VectorXd &trial);
};

/// Forces within r_N >= 0, |r_T| <= mu r_N: those given, but for what is beyond.
Eigen::VectorXd admissible(const LocalProblem &problem, const Eigen::VectorXd &forces);

/// W_ii of which no inverse can be told.
constexpr double least_compliance = 4. * std::numeric_limits<double>::min();

/// 1/W_ii, however small W_ii is beside those of other contacts; where it vanishes, that of the
/// contact's other direction, or the mean of all.
Eigen::VectorXd diagonal_stiffness(const LocalProblem &problem);

} // namespace frictionbeam::contact
