// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace frictionbeam::contact {

/**
 * The symmetric W of a LocalProblem by contacts: blocks of d x d, row by row, ascending columns; d
 * is 2 or 3. Each row has its diagonal block, be it zero.
 */
template <int d>
class BlockMatrix {
public:
  using Block = Eigen::Matrix<double, d, d>;
  using Point = Eigen::Matrix<double, d, 1>;

  explicit BlockMatrix(const Eigen::SparseMatrix<double> &matrix);

  int n_rows() const { return diagonals.size(); }
  /// Blocks of row i are those from begin(i) up to begin(i + 1).
  int begin(const int i) const { return begins[i]; }
  int column(const int k) const { return columns[k]; }
  const Block &block(const int k) const { return blocks[k]; }
  const Block &diagonal(const int i) const { return blocks[diagonals[i]]; }
  std::size_t n_blocks() const { return blocks.size(); }

  /// Row i of W r.
  Point row_times(const int i, const Eigen::VectorXd &r) const {
    Point sum = Point::Zero();
    for (int k = begins[i]; k < begins[i + 1]; ++k)
      sum.noalias() += blocks[k] * r.segment<d>(d * columns[k]);
    return sum;
  }
  Eigen::VectorXd times(const Eigen::VectorXd &r) const;

private:
  std::vector<int> begins, columns, diagonals;
  std::vector<Block> blocks;
};

} // namespace frictionbeam::contact
