// SPDX-License-Identifier: LGPL-2.1-or-later
#include "part_cholesky.h"

#include "dissection.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace frictionbeam::contact {

PartCholesky::PartCholesky(const SparseMatrix &inner, const SparseMatrix &to_border)
    : n_inner(inner.rows()), n_border(to_border.cols()) {
  order(inner);
  find_rows(inner, to_border);
  of_border = Eigen::MatrixXd::Zero(n_border, n_border);
  const Vector diagonal = inner.diagonal();
  std::vector<int> row_of(n_inner + n_border);
  for (Front &front : fronts) {
    assemble(front, inner, to_border, row_of);
    vanishes = eliminate(front, diagonal);
    if (vanishes >= 0)
      return;
    if (front.parent < 0)
      take_share(front);
  }
  of_border.triangularView<Eigen::StrictlyUpper>() = of_border.transpose();
}

void PartCholesky::order(const SparseMatrix &inner) {
  place.resize(n_inner);
  for (const Dissected &piece : dissect(inner)) {
    const int n = piece.unknowns.size();
    fronts.push_back({static_cast<int>(unknown.size()), piece.parent, {}, {}, {}, {}});
    fronts.back().factor.resize(0, n);
    for (const int i : piece.unknowns) {
      place[i] = unknown.size();
      unknown.push_back(i);
    }
  }
  for (std::size_t f = 0; f < fronts.size(); ++f)
    if (fronts[f].parent >= 0)
      fronts[fronts[f].parent].waiting.push_back(f);
}

void PartCholesky::find_rows(const SparseMatrix &inner, const SparseMatrix &to_border) {
  std::vector<const Front *> seen(n_inner + n_border, nullptr);
  for (Front &front : fronts) {
    const auto add = [&](const int row) {
      if (row < front.end() || seen[row] == &front)
        return;
      seen[row] = &front;
      front.rows.push_back(row);
    };
    for (int k = front.first; k < front.end(); ++k) {
      for (SparseMatrix::InnerIterator entry(inner, unknown[k]); entry; ++entry)
        add(place[entry.col()]);
      for (SparseMatrix::InnerIterator entry(to_border, unknown[k]); entry; ++entry)
        add(n_inner + entry.col());
    }
    for (const int child : front.waiting)
      for (const int row : fronts[child].rows)
        add(row);
    std::sort(front.rows.begin(), front.rows.end());
  }
}

void PartCholesky::assemble(Front &front, const SparseMatrix &inner, const SparseMatrix &to_border,
                            std::vector<int> &row_of) {
  const int n = front.n(), n_rows = front.rows.size();
  for (int k = 0; k < n; ++k)
    row_of[front.first + k] = k;
  for (int k = 0; k < n_rows; ++k)
    row_of[front.rows[k]] = n + k;
  front.factor = Eigen::MatrixXd::Zero(n + n_rows, n);
  front.update = Eigen::MatrixXd::Zero(n_rows, n_rows);
  for (int k = 0; k < n; ++k) {
    const int i = unknown[front.first + k];
    for (SparseMatrix::InnerIterator entry(inner, i); entry; ++entry)
      if (const int row = place[entry.col()]; row >= front.first + k)
        front.factor(row_of[row], k) += entry.value();
    for (SparseMatrix::InnerIterator entry(to_border, i); entry; ++entry)
      front.factor(row_of[n_inner + entry.col()], k) += entry.value();
  }
  for (const int child : front.waiting) {
    const std::vector<int> &rows = fronts[child].rows;
    Eigen::MatrixXd &update = fronts[child].update;
    for (std::size_t b = 0; b < rows.size(); ++b) {
      const int column = row_of[rows[b]], left_out = column < n ? 0 : n;
      double *const target =
          column < n ? front.factor.col(column).data() : front.update.col(column - n).data();
      for (std::size_t a = b; a < rows.size(); ++a)
        target[row_of[rows[a]] - left_out] += update(a, b);
    }
    update.resize(0, 0);
  }
  front.waiting = {};
}

namespace {

constexpr double nothing = 1e-13; // of the diagonal entry that a pivot began as

/// The first column of a lower triangle whose pivot vanishes; -1 if none does.
int vanishing_column(Eigen::MatrixXd triangle, const Vector &diagonal) {
  for (Eigen::Index k = 0; k < triangle.cols(); ++k) {
    const double pivot = triangle(k, k);
    if (!(pivot > nothing * diagonal[k]))
      return k;
    const Eigen::Index left = triangle.cols() - k - 1;
    const Vector column = triangle.col(k).tail(left) / std::sqrt(pivot);
    triangle.bottomRightCorner(left, left).selfadjointView<Eigen::Lower>().rankUpdate(column, -1.);
  }
  return -1;
}

} // namespace

int PartCholesky::eliminate(Front &front, const Vector &diagonal) const {
  const int n = front.n();
  auto top = front.factor.topRows(n), below = front.factor.bottomRows(front.rows.size());
  Vector began(n);
  for (int k = 0; k < n; ++k)
    began[k] = diagonal[unknown[front.first + k]];
  const Eigen::MatrixXd triangle = top;
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(top);
  if (in_place.info() != Eigen::Success)
    return unknown[front.first + std::max(0, vanishing_column(triangle, began))];
  for (int k = 0; k < n; ++k)
    if (!(top(k, k) * top(k, k) > nothing * began[k]))
      return unknown[front.first + k];
  top.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
  front.update.selfadjointView<Eigen::Lower>().rankUpdate(below, -1.);
  return -1;
}

void PartCholesky::take_share(Front &root) {
  for (std::size_t b = 0; b < root.rows.size(); ++b)
    for (std::size_t a = b; a < root.rows.size(); ++a)
      of_border(root.rows[a] - n_inner, root.rows[b] - n_inner) += root.update(a, b);
  root.update.resize(0, 0);
}

Vector PartCholesky::forward(const Vector &forces) const {
  Vector y = Vector::Zero(n_inner + n_border);
  for (int k = 0; k < n_inner; ++k)
    y[k] = forces[unknown[k]];
  for (const Front &front : fronts) {
    const int n = front.n();
    auto own = y.segment(front.first, n);
    front.factor.topRows(n).triangularView<Eigen::Lower>().solveInPlace(own);
    const Vector below = front.factor.bottomRows(front.rows.size()) * own;
    for (std::size_t k = 0; k < front.rows.size(); ++k)
      y[front.rows[k]] -= below[k];
  }
  return y;
}

Vector PartCholesky::condense(const Vector &forces) const { return forward(forces).tail(n_border); }

Vector PartCholesky::solve(const Vector &forces) const {
  Vector y = forward(forces);
  y.tail(n_border).setZero(); // the border is held
  for (auto front = fronts.rbegin(); front != fronts.rend(); ++front) {
    const int n = front->n();
    Vector below(front->rows.size());
    for (std::size_t k = 0; k < front->rows.size(); ++k)
      below[k] = y[front->rows[k]];
    auto own = y.segment(front->first, n);
    own -= front->factor.bottomRows(below.size()).transpose() * below;
    front->factor.topRows(n).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
  Vector result(n_inner);
  for (int k = 0; k < n_inner; ++k)
    result[unknown[k]] = y[k];
  return result;
}

} // namespace frictionbeam::contact
