// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/local_residual.h>

#include <limits>

namespace frictionbeam::contact {

struct LocalSolution {
  Eigen::VectorXd reactions; ///< r, the best found
  Eigen::VectorXd motions;   ///< u = W r + q
  LocalResidual residual;
  bool converged = false;
  bool out_of_time = false;          ///< and therefore not converged
  unsigned int outer_iterations = 0; ///< proximal steps
  unsigned int iterations = 0;       ///< of Newton's method, a factorization each
  unsigned int sweeps = 0;           ///< of the Gauss-Seidel iteration
};

/**
 * Solve by two methods that take turns: projected Gauss-Seidel sweeps on the blocks of W, and the
 * proximal-point semismooth Newton iteration of ExactSolver, on W: around a centre r_c each contact
 * is given the compliance 1/(c k), k = 1/W_ii of its components, which adds (r - r_c)/(c k) to u;
 * Newton's method with a line search solves that; then r_c = r and c grows, or falls where Newton
 * fails. Once no contact changes its state any more, steps as good as without that term follow,
 * with u in extended precision. Only the residual of the problem itself decides:
 * LocalResidual::holds().
 *
 * Equal problems give equal answers, unless time runs out.
 *
 * @param time_limit [s], of the clock on the wall
 * @throws std::invalid_argument if sizes do not fit, W is not symmetric or a number is none
 *
 * With a singular W the forces may not be unique (the compliance then chooses), and there may be no
 * solution.
 */
LocalSolution
solve_local_contact(const LocalProblem &problem, const double tolerance,
                    const double time_limit = std::numeric_limits<double>::infinity());

} // namespace frictionbeam::contact
