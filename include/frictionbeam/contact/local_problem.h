// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <string>

namespace frictionbeam::contact {

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
struct LocalProblem {
  unsigned int dimension = 3;
  Eigen::SparseMatrix<double> W; ///< symmetric, positive semidefinite [m/N]
  Eigen::VectorXd q;             ///< [m]
  Eigen::VectorXd friction;      ///< mu, one for each contact

  unsigned int n_contacts() const { return friction.size(); }
};

} // namespace frictionbeam::contact
