// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/SparseCore>

#include <memory>

namespace frictionbeam {

/**
 * A = L L^T of a symmetric positive definite matrix whose last unknowns are eliminated last, so
 * that the last block of L is that of the matrix condensed to them. By CHOLMOD's supernodal method,
 * which works on dense blocks: Chen, Davis, Hager and Rajamanickam, ACM Trans. Math. Softw. 35
 * (2008), doi 10.1145/1391989.1391995.
 */
class BlockCholesky {
public:
  BlockCholesky();
  ~BlockCholesky();

  /**
   * @param lower triangle of A, in an order that keeps L sparse
   * @param n_last unknowns that the last block is of
   * @return whether A is positive definite
   */
  bool compute(const Eigen::SparseMatrix<double> &lower, const int n_last);

  /// Solve L y = y and L^T y = y, of all columns at once. Between the two, unknowns before the last
  /// block stand in an order of CHOLMOD's own.
  void solve_lower(Eigen::MatrixXd &y) const;
  void solve_upper(Eigen::MatrixXd &y) const;

  const Eigen::MatrixXd &last_block() const { return block; } ///< of L, a lower triangle

private:
  void read_last_block(const int n_last);

  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod;
  Eigen::MatrixXd block;
};

/// A permutation of a symmetric matrix (old place by new) that keeps its factor sparse, whose last
/// @p n_last unknowns stay where they are.
Eigen::VectorXi sparse_order(const Eigen::SparseMatrix<double> &lower, const int n_last);
/// The matrix, of which and by which the lower triangle is given, in such an order.
Eigen::SparseMatrix<double> in_order(const Eigen::SparseMatrix<double> &lower,
                                     const Eigen::VectorXi &order);

} // namespace frictionbeam
