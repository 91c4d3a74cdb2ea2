// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <string>

namespace frictionbeam {

/**
 * A friction-contact problem condensed to its contacts: find u and r with
 *   u = W r + q,   0 <= u_N perp r_N >= 0,   |r_T| <= mu r_N,   r_T = -mu r_N u_T/|u_T| if u_T !=
 * 0. The components of a contact stand together: normal, then one tangential (dimension 2) or two
 * (dimension 3). u are relative displacements (or velocities), the gap first; r are the forces (or
 * impulses) of the ground on the body.
 *
 * The same in one line, K the cone |r_T| <= mu r_N, K* its dual: K* contains u + mu |u_T| n,
 * orthogonal to r in K. Acary, Bremond, Huber, On solving contact problems with Coulomb friction:
 * formulations and numerical comparisons, 2018.
 */
struct LocalContactProblem {
  unsigned int dimension = 3;
  Eigen::SparseMatrix<double> W; ///< symmetric, positive semidefinite [m/N]
  Eigen::VectorXd q;             ///< [m]
  Eigen::VectorXd friction;      ///< mu, one for each contact

  unsigned int n_contacts() const { return friction.size(); }
};

/// How far reactions are from solving a LocalContactProblem.
struct LocalContactResidual {
  /// As in the literature: ||r - P_K(r - (u + mu |u_T| n))|| / ||q||, in the units of the file.
  double natural_map = 0.;
  /// Largest of a contact on its own scale, whatever the units: with rho = 1/W_NN of the contact,
  /// ||r - P(r - rho u)|| / max(|r|, rho |u|, 1e-12 of the largest reaction), where P is onto
  /// r_N >= 0 and then onto the disc mu r_N. What rounding errors of u account for does not count.
  double own_scale = 0.;
  unsigned int worst_contact = 0; ///< that has it
};

LocalContactResidual evaluate_residual(const LocalContactProblem &problem,
                                       const Eigen::VectorXd &reactions);

struct LocalContactSolution {
  Eigen::VectorXd reactions; ///< r, the best found
  Eigen::VectorXd motions;   ///< u = W r + q
  LocalContactResidual residual;
  bool converged = false;
  unsigned int outer_iterations = 0, iterations = 0;
};

/**
 * Solve by the proximal-point semismooth Newton iteration of ExactSolver, on W: around a centre r_c
 * each contact is given the compliance 1/(c k), k = 1/W_ii of its components, which adds
 * (r - r_c)/(c k) to u; Newton's method with a line search solves that; then r_c = r and c grows,
 * or falls where Newton fails. Once no contact changes its state any more, plain Newton steps
 * without that term are tried. Only the residual of the problem itself decides: both measures of
 * LocalContactResidual below @p tolerance.
 *
 * With a singular W the forces may not be unique (the compliance then chooses), and there may be no
 * solution.
 */
LocalContactSolution solve_local_contact(const LocalContactProblem &problem,
                                         const double tolerance);

/// The rank of W, its rows and columns scaled to a unit diagonal, to @p tolerance; -1 where W is
/// too large to say so in a short time.
int estimate_rank(const LocalContactProblem &problem, const double tolerance = 1e-12);

} // namespace frictionbeam
