// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace frictionbeam {

/// What motions do to a contact with Coulomb's friction.
struct MovedContact {
  Eigen::Matrix<double, 3, Eigen::Dynamic> motion; ///< of unit motions: into the ground, and across
  double friction = 0.;
};

/**
 * The motion w, a sum of motions that strain nothing, that proves that loads have no equilibrium:
 * they do work on it, g . w > 0, and every contact opens by mu times what it slides, or more,
 *   -d_N >= mu |d_T|,
 * so that no force that friction allows takes any of that work (Farkas' lemma). If forces on the
 * contacts can hold the loads there is none.
 *
 * It is what the allowed forces leave at least of the loads, w = g + sum l_k a_k, l_k >= 0, a_k
 * forces on the cones' surfaces: the method of C. L. Lawson and R. J. Hanson (Solving Least Squares
 * Problems, 1974, ch. 23) with columns that are made where they are wanted.
 *
 * @param loads g, the work of the loads on unit motions
 * @param contacts of this process; the answer is that of all
 * @return nothing if there is no such motion: then forces up to 1e6 times the loads may hold them
 */
std::optional<Eigen::VectorXd> unresisted_motion(const Eigen::VectorXd &loads,
                                                 const std::vector<MovedContact> &contacts,
                                                 const MPI_Comm communicator);

} // namespace frictionbeam
