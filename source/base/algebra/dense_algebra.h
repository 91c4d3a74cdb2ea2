// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

namespace frictionbeam {

// What dense matrices of any size are asked for, made once from Eigen's templates: in each file
// that asks, these would take longer than all the rest of it.

/**
 * Of all x with the least |A x - b|, the shortest one; A of any shape and rank. By a complete
 * orthogonal decomposition (Golub and Van Loan, Matrix Computations, 4th ed., 5.5.2).
 */
class LeastSquares {
public:
  LeastSquares() = default;
  explicit LeastSquares(const Eigen::MatrixXd &A);
  /// @param threshold below which, of the largest, pivots are taken for zero
  LeastSquares(const Eigen::MatrixXd &A, double threshold);

  Eigen::Index rank() const;
  Eigen::VectorXd solve(const Eigen::VectorXd &b) const;
  /// Moore and Penrose's A^+: x = A^+ b.
  Eigen::MatrixXd pseudo_inverse() const;

private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
};

struct SymmetricEigen {
  Eigen::VectorXd values;  ///< rising
  Eigen::MatrixXd vectors; ///< columns
};

/// A x = lambda x, |x| = 1, of a symmetric A, of which the lower half is read.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd &A);

/// A x = lambda B x, x^T B x = 1, of a symmetric A and a positive definite B.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd &A, const Eigen::MatrixXd &B);

/// Columns in the order in which each adds most to those before it.
Eigen::VectorXi most_independent_columns(const Eigen::MatrixXd &A);

} // namespace frictionbeam
