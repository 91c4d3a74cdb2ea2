// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_matrix.h"

#include <frictionbeam/contact/local_problem.h>

namespace frictionbeam::contact {

/**
 * Projected Gauss-Seidel iteration on a LocalProblem: each contact in turn is solved exactly with
 * the forces of the others as they are. A sweep costs one product with W. It is quick where
 * contacts are coupled loosely, and where it is slow it still finds most of what sticks, slips and
 * is open. (M. Jean, The non-smooth contact dynamics method, Comput. Methods Appl. Mech. Engrg.
 * 177, 1999, doi:10.1016/S0045-7825(98)00383-1.)
 */
template <int d>
class GaussSeidel {
public:
  GaussSeidel(const LocalProblem &problem, const BlockMatrix<d> &W);

  /// Once through all contacts, in their order or against it.
  void sweep(Eigen::VectorXd &r, const bool forwards) const;
  /// Of a sweep, in products of blocks: a contact by itself costs as much as ten.
  double work() const { return W.n_blocks() + 10. * W.n_rows(); }

private:
  using Point = typename BlockMatrix<d>::Point;
  using Shear = Eigen::Matrix<double, d - 1, 1>;
  using ShearBlock = Eigen::Matrix<double, d - 1, d - 1>;

  /// Of one contact: W_ii with the normal force eliminated by u_N = 0, S = W_TT - W_TN W_NT / W_NN,
  /// by its eigenvectors.
  struct Alone {
    double normal;   ///< 1/W_NN
    Shear coupling;  ///< W_TN / W_NN
    ShearBlock axes; ///< eigenvectors of S in columns
    Shear stiffness; ///< eigenvalues of S
  };
  static Alone alone(const typename BlockMatrix<d>::Block &W);
  /// The force of one contact whose motion is W_ii r + q.
  static Point solve(const Alone &of, const double friction, const Point &q);
  /// ... that slips: u_T = -alpha r_T, alpha > 0. @param b q_T - W_TN q_N / W_NN along the axes
  static Point slip(const Alone &of, const double friction, const Point &q, const Shear &b);
  /// r_T = -(S + alpha)^-1 b with |r_T| = mu r_N, along the axes.
  static Shear find_shear(const Alone &of, const double friction, const double pressed,
                          const Shear &coupling, const Shear &b);

  const LocalProblem &problem;
  const BlockMatrix<d> &W;
  std::vector<Alone> contacts;
};

} // namespace frictionbeam::contact
