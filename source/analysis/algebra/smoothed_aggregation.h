// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/SparseCholesky>

#include <vector>

namespace frictionbeam {

/**
 * Algebraic multigrid by smoothed aggregation (P. Vanek, J. Mandel, M. Brezina, Computing 56 (1996)
 * 179-196) for symmetric positive definite matrices of elasticity, in one process: nodes, each
 * with a few unknowns, are gathered into aggregates whose functions are the rigid motions,
 * smoothed once; Gauss-Seidel sweeps by nodes, forward before and backward after, so that a cycle
 * is a symmetric operator; a factorization at the bottom.
 */
class SmoothedAggregation {
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// @param node_begin first unknown of each node, and the number of unknowns
  /// @param modes a column for each motion that has next to no energy
  SmoothedAggregation(Matrix matrix, std::vector<int> node_begin, Eigen::MatrixXd modes);

  /// One cycle, from zero, for A x = b.
  void cycle(Eigen::VectorXd &x, const Eigen::VectorXd &b) const { cycle(0, x, b); }

  unsigned int n_levels() const { return levels.size() + 1; }
  /// Non-zero entries of all levels, relative to the first one's.
  double operator_complexity() const;

private:
  struct Level {
    Matrix matrix, prolongation;
    std::vector<int> node_begin;
    std::vector<double> inverses; ///< of the nodes' own blocks, node after node, by columns
    mutable Eigen::VectorXd x, b; ///< of the next level
  };

  static void invert_blocks(Level &level);
  static void sweep(const Level &level, Eigen::VectorXd &x, const Eigen::VectorXd &b,
                    const bool backward);
  void cycle(const std::size_t number, Eigen::VectorXd &x, const Eigen::VectorXd &b) const;

  std::vector<Level> levels;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> bottom;
  double bottom_entries = 0.;
};

} // namespace frictionbeam
