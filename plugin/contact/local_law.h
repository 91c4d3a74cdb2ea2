// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/local_problem.h>

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

/// 1/W_ii, with the mean of the others where W_ii vanishes.
Eigen::VectorXd diagonal_stiffness(const LocalProblem &problem);

} // namespace frictionbeam::contact
