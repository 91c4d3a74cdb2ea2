// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/local_problem.h>

#include <algorithm>

namespace frictionbeam::contact {

/// How far reactions are from solving a LocalProblem. Motions u = W r + q are summed in extended
/// precision; what remains is that reactions themselves are rounded.
struct LocalResidual {
  /// As in the literature: ||r - P_K(r - (u + mu |u_T| n))|| / ||q||, in the units of the file.
  double natural_map = 0.;
  /// What rounding of r and u makes of it: where forces are large beside motions, in numbers, more
  /// than any tolerance.
  double rounding = 0.;
  /// Largest of a contact on its own scale, whatever the units: with rho = 1/W_NN of the contact,
  /// ||r - P(r - rho u)|| / max(|r|, rho |u|, 1e-12 rho (|W| |r| + |q|)), where P is onto r_N >= 0
  /// and then onto the disc mu r_N; and of its motion, ||(r - P)/rho|| relative to the largest |q|
  /// of the contacts that W couples it with, for where there is no solution r grows without bound,
  /// and anything is small beside it. What rounding of the reactions makes of u, 8 eps (|W| |r| +
  /// |q|), does not count, up to 1e-3 of that |q|.
  double own_scale = 0.;
  unsigned int worst_contact = 0; ///< that has it

  bool holds(const double tolerance) const {
    return own_scale <= tolerance && natural_map <= std::max(tolerance, rounding);
  }
};

LocalResidual evaluate_residual(const LocalProblem &problem, const Eigen::VectorXd &reactions);

/// u = W r + q, summed in extended precision.
Eigen::VectorXd motions_of(const LocalProblem &problem, const Eigen::VectorXd &reactions);

/// The rank of W, its rows and columns scaled to a unit diagonal, to @p tolerance; -1 where W is
/// too large to say so in a short time.
int estimate_rank(const LocalProblem &problem, const double tolerance = 1e-12);

} // namespace frictionbeam::contact
