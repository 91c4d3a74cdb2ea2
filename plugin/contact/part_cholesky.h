// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/matrix.h>

#include <vector>

namespace frictionbeam::contact {

/**
 * Cholesky factorization of the inner unknowns of a part of a body, which gives what they add to
 * the stiffness of its border, -K_bi K_ii^-1 K_ib, without a solution for each unknown of the
 * border.
 *
 * It is multifrontal, on a nested dissection of the inner unknowns: a front is a dense lower
 * triangle of what is eliminated there and what that touches later; eliminating it leaves an update
 * of the latter, which is added to its parent. The border comes last in each front that touches it
 * and is never eliminated, so that what the roots leave is the part's share. (I. S. Duff, J. K.
 * Reid, The multifrontal solution of indefinite sparse symmetric linear equations, ACM Trans. Math.
 * Softw. 9, 1983, doi:10.1145/356044.356047.)
 */
class PartCholesky {
public:
  /// @param inner K_ii, symmetric, both triangles; @param to_border K_ib
  PartCholesky(const SparseMatrix &inner, const SparseMatrix &to_border);

  /**
   * Whether K_ii is positive definite: no pivot is as small as 1e-13 of the diagonal entry that it
   * began as. Where nothing should be left, as where a part moves freely, rounding leaves up to
   * 3e-14 of it (measured on free blocks of 45 to 15,147 unknowns), with either sign. Nothing below
   * may be called if not.
   */
  bool ok() const { return vanishes < 0; }
  /// The inner unknown at which it shows that K_ii is not; -1 if it is.
  int vanishing() const { return vanishes; }
  /// -K_bi K_ii^-1 K_ib.
  const Eigen::MatrixXd &share() const { return of_border; }
  /// -K_bi K_ii^-1 f.
  Vector condense(const Vector &forces) const;
  /// K_ii^-1 f.
  Vector solve(const Vector &forces) const;

private:
  /// Columns of the factor.
  struct Front {
    int first, parent;        ///< place of the first column, the others follow; place among fronts
    std::vector<int> rows;    ///< places below the columns, in ascending order
    Eigen::MatrixXd factor;   ///< by columns; on top their own rows, a lower triangle
    Eigen::MatrixXd update;   ///< lower triangle on the rows, until the parent has taken it
    std::vector<int> waiting; ///< children, until their updates are taken

    int n() const { return factor.cols(); }
    int end() const { return first + n(); }
  };

  void order(const SparseMatrix &inner);
  void find_rows(const SparseMatrix &inner, const SparseMatrix &to_border);
  /// @param row_of a place in the front: work space
  void assemble(Front &front, const SparseMatrix &inner, const SparseMatrix &to_border,
                std::vector<int> &row_of);
  /// @return the inner unknown whose pivot vanishes; -1 if none does
  int eliminate(Front &front, const Vector &diagonal) const;
  void take_share(Front &root);
  /// L^-1 f on the places of the inner unknowns, and what that leaves on the border.
  Vector forward(const Vector &forces) const;

  int n_inner, n_border;
  std::vector<int> place, unknown; ///< of an inner unknown in the factor, and the other way round
  std::vector<Front> fronts;       ///< children before their parents
  Eigen::MatrixXd of_border;
  int vanishes = -1;
};

} // namespace frictionbeam::contact
