// SPDX-License-Identifier: LGPL-2.1-or-later
#include "part_cholesky.h"

#include <Eigen/OrderingMethods>

namespace frictionbeam::contact {

PartCholesky::PartCholesky(const SparseMatrix &inner, const SparseMatrix &to_border,
                           const Eigen::MatrixXd &border)
    : place(inner.rows()), n_inner(inner.rows()), n_border(border.rows()) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order; // old place by new
  Eigen::AMDOrdering<int>()(Sparse(inner), order);
  for (Eigen::Index k = 0; k < n_inner; ++k)
    place[order.indices()[k]] = k;
  const double shift = std::max(inner.diagonal().maxCoeff(), border.diagonal().maxCoeff());
  std::vector<Eigen::Triplet<double>> entries; // lower triangle
  entries.reserve(inner.nonZeros() / 2 + to_border.nonZeros() + n_inner + n_border * n_border / 2);
  for (int i = 0; i < n_inner; ++i) {
    for (SparseMatrix::InnerIterator entry(inner, i); entry; ++entry)
      if (place[i] >= place[entry.col()])
        entries.emplace_back(place[i], place[entry.col()], entry.value());
    for (SparseMatrix::InnerIterator entry(to_border, i); entry; ++entry)
      entries.emplace_back(n_inner + entry.col(), place[i], entry.value());
  }
  for (Eigen::Index b = 0; b < n_border; ++b)
    for (Eigen::Index a = b; a < n_border; ++a)
      if (const double value = border(a, b) + (a == b ? shift : 0.); value != 0.)
        entries.emplace_back(n_inner + a, n_inner + b, value);
  Sparse matrix(n_inner + n_border, n_inner + n_border);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors.compute(matrix);
  is_factored = factors.info() == Eigen::Success && (factors.vectorD().array() > 0.).all();
  if (!is_factored)
    return;
  last_block = Eigen::MatrixXd::Identity(n_border, n_border);
  const Sparse &L = factors.matrixL().nestedExpression();
  for (Eigen::Index j = 0; j < n_border; ++j)
    for (Sparse::InnerIterator entry(L, n_inner + j); entry; ++entry)
      if (entry.row() > n_inner + j)
        last_block(entry.row() - n_inner, j) = entry.value();
  const Eigen::MatrixXd scaled =
      last_block * factors.vectorD().tail(n_border).cwiseSqrt().asDiagonal();
  of_border = Eigen::MatrixXd::Zero(n_border, n_border);
  of_border.selfadjointView<Eigen::Lower>().rankUpdate(scaled);
  of_border = Eigen::MatrixXd(of_border.selfadjointView<Eigen::Lower>());
  of_border -= border;
  of_border.diagonal().array() -= shift;
}

Vector PartCholesky::condense(const Vector &forces) const {
  Vector y = Vector::Zero(n_inner + n_border);
  for (Eigen::Index i = 0; i < n_inner; ++i)
    y[place[i]] = forces[i];
  factors.matrixL().solveInPlace(y);
  return last_block.triangularView<Eigen::UnitLower>() * y.tail(n_border);
}

Vector PartCholesky::solve(const Vector &forces) const {
  Vector y = Vector::Zero(n_inner + n_border);
  for (Eigen::Index i = 0; i < n_inner; ++i)
    y[place[i]] = forces[i];
  factors.matrixL().solveInPlace(y);
  y.array() /= factors.vectorD().array();
  y.tail(n_border).setZero(); // the border is held
  factors.matrixU().solveInPlace(y);
  Vector result(n_inner);
  for (Eigen::Index i = 0; i < n_inner; ++i)
    result[i] = y[place[i]];
  return result;
}

} // namespace frictionbeam::contact
