// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/matrix.h>

#include <Eigen/SparseCholesky>

#include <vector>

namespace frictionbeam::contact {

/**
 * Sparse Cholesky factorization of a part of a body with its border last, [K_ii K_ib; K_bi K_bb +
 * shift], so that the last block of the factor gives what the part adds to the border's stiffness,
 * -K_bi K_ii^-1 K_ib: one factorization in place of a solution for each unknown of the border. The
 * shift makes it positive definite and is taken off again.
 */
class PartCholesky {
public:
  /// @param inner K_ii, symmetric, both triangles; @param to_border K_ib; @param border K_bb
  /// @return in `ok` whether it is positive definite
  PartCholesky(const SparseMatrix &inner, const SparseMatrix &to_border,
               const Eigen::MatrixXd &border);

  bool ok() const { return is_factored; }
  /// -K_bi K_ii^-1 K_ib.
  const Eigen::MatrixXd &share() const { return of_border; }
  /// -K_bi K_ii^-1 f.
  Vector condense(const Vector &forces) const;
  /// K_ii^-1 f.
  Vector solve(const Vector &forces) const;

private:
  using Sparse = Eigen::SparseMatrix<double>;

  std::vector<int> place; ///< of each inner unknown in the factor
  Eigen::Index n_inner = 0, n_border = 0;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> factors;
  Eigen::MatrixXd last_block, of_border;
  bool is_factored = false;
};

} // namespace frictionbeam::contact
