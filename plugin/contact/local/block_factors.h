// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_matrix.h"

namespace frictionbeam::contact {

/**
 * L U factorization of a matrix of blocks with a symmetric pattern, for Newton's step on the
 * forces of contacts: contacts are eliminated in an order of least degree, without pivoting but
 * within their diagonal blocks. Row by row (T. A. Davis, Direct Methods for Sparse Linear Systems,
 * SIAM 2006, chapters 4 and 6): what a row of L touches follows from the elimination tree.
 */
template <int d>
class BlockFactors {
public:
  using Block = typename BlockMatrix<d>::Block;

  /// Order the contacts of a list, and find the pattern of the factors on them.
  void analyze(const BlockMatrix<d> &W, const std::vector<int> &contacts);

  /// Factor the matrix of blocks left_i W_ij, with what is added on the diagonal.
  /// @param left, diagonal one for each contact of the problem
  /// @return false if a pivot vanishes: no factors then
  bool factorize(const BlockMatrix<d> &W, const std::vector<Block> &left,
                 const std::vector<Block> &diagonal);

  /// Solve on the contacts of the list; entries of others are neither read nor changed.
  void solve(Eigen::VectorXd &x) const;

  /// Products of blocks that a factorization takes.
  double work() const { return products; }

private:
  void find_pattern(const BlockMatrix<d> &W);

  std::vector<int> contact_of; ///< in the order of elimination
  std::vector<int> place_of;   ///< of a contact of the problem; -1 if it is not in the list
  std::vector<int> parent;     ///< elimination tree
  std::vector<int> begins;     ///< of each row of U, the diagonal apart
  std::vector<int> rows;       ///< columns of U, rows of L
  std::vector<int> l_begins, l_columns; ///< rows of L
  std::vector<Block> lower, upper, inverse;
  double products = 0.;
};

} // namespace frictionbeam::contact
