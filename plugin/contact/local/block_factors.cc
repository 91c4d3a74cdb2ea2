// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_factors.h"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>

#include <algorithm>

namespace frictionbeam::contact {

template <int d>
void BlockFactors<d>::analyze(const BlockMatrix<d> &W, const std::vector<int> &contacts) {
  const int n = contacts.size();
  place_of.assign(W.n_rows(), -1);
  for (int k = 0; k < n; ++k)
    place_of[contacts[k]] = k;
  std::vector<Eigen::Triplet<char>> pairs;
  for (int k = 0; k < n; ++k)
    for (int p = W.begin(contacts[k]); p < W.begin(contacts[k] + 1); ++p)
      if (const int j = place_of[W.column(p)]; j >= 0)
        pairs.emplace_back(k, j, 1);
  Eigen::SparseMatrix<char> pattern(n, n);
  pattern.setFromTriplets(pairs.begin(), pairs.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);
  contact_of.resize(n);
  for (int k = 0; k < n; ++k) {
    contact_of[k] = contacts[order.indices()[k]];
    place_of[contact_of[k]] = k;
  }
  find_pattern(W);
}

template <int d>
void BlockFactors<d>::find_pattern(const BlockMatrix<d> &W) {
  const int n = contact_of.size();
  std::vector<int> visited(n, -1), count(n, 0);
  parent.assign(n, -1);
  l_begins.assign(1, 0);
  l_columns.clear();
  for (int k = 0; k < n; ++k) {
    visited[k] = k;
    for (int p = W.begin(contact_of[k]); p < W.begin(contact_of[k] + 1); ++p)
      for (int i = place_of[W.column(p)]; i >= 0 && i < k && visited[i] != k; i = parent[i]) {
        if (parent[i] == -1)
          parent[i] = k;
        ++count[i];
        visited[i] = k;
        l_columns.push_back(i);
      }
    std::sort(l_columns.begin() + l_begins.back(), l_columns.end());
    l_begins.push_back(l_columns.size());
  }
  begins.assign(n + 1, 0);
  products = 0.;
  for (int k = 0; k < n; ++k) {
    begins[k + 1] = begins[k] + count[k];
    products += (count[k] + 1.) * (count[k] + 1.);
  }
  rows.resize(begins[n]);
  std::vector<int> end(begins.begin(), begins.end() - 1);
  for (int k = 0; k < n; ++k)
    for (int p = l_begins[k]; p < l_begins[k + 1]; ++p)
      rows[end[l_columns[p]]++] = k;
  lower.resize(rows.size());
  upper.resize(rows.size());
  inverse.resize(n);
}

template <int d>
bool BlockFactors<d>::factorize(const BlockMatrix<d> &W, const std::vector<Block> &left,
                                const std::vector<Block> &diagonal) {
  constexpr double most_ill_conditioned = 1e15;
  const int n = contact_of.size();
  std::vector<Block> row(n, Block::Zero());
  for (int k = 0; k < n; ++k) {
    const int contact = contact_of[k];
    for (int p = W.begin(contact); p < W.begin(contact + 1); ++p)
      if (const int j = place_of[W.column(p)]; j >= 0)
        row[j].noalias() = left[contact] * W.block(p);
    row[k] += diagonal[contact];
    for (int p = l_begins[k]; p < l_begins[k + 1]; ++p) {
      const int i = l_columns[p];
      const Block l = row[i] * inverse[i];
      row[i].setZero();
      for (int s = begins[i]; s < begins[i + 1]; ++s)
        row[rows[s]].noalias() -= l * upper[s];
      lower[p] = l;
    }
    inverse[k] = row[k].inverse();
    if (!(inverse[k].norm() * row[k].norm() < most_ill_conditioned))
      return false;
    row[k].setZero();
    for (int s = begins[k]; s < begins[k + 1]; ++s) {
      upper[s] = row[rows[s]];
      row[rows[s]].setZero();
    }
  }
  return true;
}

template <int d>
void BlockFactors<d>::solve(Eigen::VectorXd &x) const {
  const int n = contact_of.size();
  using Point = typename BlockMatrix<d>::Point;
  std::vector<Point> y(n);
  for (int k = 0; k < n; ++k) {
    Point sum = x.template segment<d>(d * contact_of[k]);
    for (int p = l_begins[k]; p < l_begins[k + 1]; ++p)
      sum.noalias() -= lower[p] * y[l_columns[p]];
    y[k] = sum;
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int s = begins[k]; s < begins[k + 1]; ++s)
      y[k].noalias() -= upper[s] * y[rows[s]];
    y[k] = inverse[k] * y[k];
    x.template segment<d>(d * contact_of[k]) = y[k];
  }
}

template class BlockFactors<2>;
template class BlockFactors<3>;

} // namespace frictionbeam::contact
