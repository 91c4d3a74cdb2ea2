// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/matrix.h>

#include <algorithm>

namespace frictionbeam::contact {

/**
 * L D U factorization of an unsymmetric sparse matrix with symmetric pattern, without pivoting: a
 * line's stiffness with the unsymmetric blocks of slipping contacts on its diagonal. It costs twice
 * a symmetric factorization of the same pattern and, with unknowns numbered along the line, is
 * linear in its length. Where natural numbering fills in (loops), minimum degree is used instead.
 *
 * Up-looking elimination along the elimination tree (T. A. Davis, Direct Methods for Sparse Linear
 * Systems, SIAM 2006, chapter 4), carried out for rows of L and columns of U at once
 * (doc/theory.md, "Methods of return mapping", linear algebra).
 */
class LineFactorization {
public:
  /// Ordering and pattern of the factors; values are not read.
  void analyze(const SparseMatrix &matrix);

  /// Factor a matrix of the analyzed pattern. @return false if a pivot vanishes: no factors then.
  bool factorize(const SparseMatrix &matrix);

  /// Solve with the last factors.
  Vector solve(const Vector &right_hand_side) const;

  /// Of the diagonal D; of a symmetric matrix it is positive just where the matrix is positive
  /// definite.
  double least_pivot() const { return *std::min_element(diagonal.begin(), diagonal.end()); }

  std::size_t n_nonzeros() const { return column_rows.size(); }

private:
  void order(const SparseMatrix &matrix);
  std::size_t find_tree(const SparseMatrix &matrix, const std::vector<int> &new_of_old,
                        const std::vector<int> &old_of_new);

  std::vector<int> new_of_old, old_of_new;
  std::vector<int> parent;          ///< elimination tree
  std::vector<std::size_t> columns; ///< start of each column of L (and row of U)
  std::vector<int> column_rows;     ///< row indices of L
  std::vector<double> lower, upper, diagonal;
};

} // namespace frictionbeam::contact
