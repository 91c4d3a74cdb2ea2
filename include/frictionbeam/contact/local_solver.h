// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/local_residual.h>

namespace frictionbeam::contact {

struct LocalSolution {
  Eigen::VectorXd reactions; ///< r, the best found
  Eigen::VectorXd motions;   ///< u = W r + q
  LocalResidual residual;
  bool converged = false;
  unsigned int outer_iterations = 0, iterations = 0;
};

/**
 * Solve by the proximal-point semismooth Newton iteration of ExactSolver, on W: around a centre r_c
 * each contact is given the compliance 1/(c k), k = 1/W_ii of its components, which adds
 * (r - r_c)/(c k) to u; Newton's method with a line search solves that; then r_c = r and c grows,
 * or falls where Newton fails. Once no contact changes its state any more, plain Newton steps
 * without that term are tried. Only the residual of the problem itself decides: both measures of
 * LocalResidual below @p tolerance.
 *
 * @throws std::invalid_argument if sizes do not fit, W is not symmetric or a number is none
 *
 * With a singular W the forces may not be unique (the compliance then chooses), and there may be no
 * solution.
 */
LocalSolution solve_local_contact(const LocalProblem &problem, const double tolerance);

} // namespace frictionbeam::contact
