// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/line_factorization.h>

#include <Eigen/OrderingMethods>

#include <cmath>
#include <numeric>

namespace frictionbeam::contact {

void LineFactorization::analyze(const SparseMatrix &matrix) {
  order(matrix);
  const std::size_t n = matrix.rows();
  lower.resize(columns[n]);
  upper.resize(columns[n]);
  column_rows.resize(columns[n]);
  diagonal.resize(n);
}

void LineFactorization::order(const SparseMatrix &matrix) {
  const std::size_t n = matrix.rows();
  new_of_old.resize(n);
  std::iota(new_of_old.begin(), new_of_old.end(), 0);
  old_of_new = new_of_old;
  const std::size_t natural_fill = find_tree(matrix, new_of_old, old_of_new);
  if (natural_fill <= 2 * static_cast<std::size_t>(matrix.nonZeros()))
    return;

  Eigen::SparseMatrix<double, Eigen::ColMajor, int> pattern = matrix;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(pattern, permutation);
  std::vector<int> old_indices(permutation.indices().data(), permutation.indices().data() + n),
      new_indices(n);
  for (std::size_t k = 0; k < n; ++k)
    new_indices[old_indices[k]] = k;
  if (find_tree(matrix, new_indices, old_indices) < natural_fill) {
    new_of_old = new_indices;
    old_of_new = old_indices;
  } else
    find_tree(matrix, new_of_old, old_of_new);
}

std::size_t LineFactorization::find_tree(const SparseMatrix &matrix,
                                         const std::vector<int> &new_of_old,
                                         const std::vector<int> &old_of_new) {
  const int n = matrix.rows();
  std::vector<std::size_t> count(n, 0);
  std::vector<int> visited(n, -1);
  parent.assign(n, -1);
  for (int k = 0; k < n; ++k) {
    visited[k] = k;
    const int row = old_of_new[k];
    for (int p = matrix.outerIndexPtr()[row]; p < matrix.outerIndexPtr()[row + 1]; ++p)
      for (int i = new_of_old[matrix.innerIndexPtr()[p]]; i < k && visited[i] != k; i = parent[i]) {
        if (parent[i] == -1)
          parent[i] = k;
        ++count[i];
        visited[i] = k;
      }
  }
  columns.assign(n + 1, 0);
  std::partial_sum(count.begin(), count.end(), columns.begin() + 1);
  return columns[n];
}

bool LineFactorization::factorize(const SparseMatrix &matrix) {
  const int n = matrix.rows();
  const int *const outer = matrix.outerIndexPtr(), *const inner = matrix.innerIndexPtr();
  const double *const values = matrix.valuePtr();
  std::vector<std::size_t> end(columns.begin(), columns.end() - 1);
  std::vector<int> visited(n, -1), path(n), reach(n);
  std::vector<double> row_values(n, 0.), column_values(n, 0.);
  // Unknowns as numbered ask for the mirrors of a row's entries one after the other.
  const bool is_natural = std::is_sorted(new_of_old.begin(), new_of_old.end());
  std::vector<int> mirrored(is_natural ? n : 0); // of each row, the next that is asked for

  for (int k = 0; k < n; ++k) {
    // Pattern of row k of L: what the entries of the row reach in the tree, in topological order.
    int top = n;
    visited[k] = k;
    double pivot = 0., size = 0.;
    const int row = old_of_new[k];
    if (is_natural)
      mirrored[k] = outer[k];
    for (int p = outer[row]; p < outer[row + 1]; ++p) {
      int i = new_of_old[inner[p]];
      if (is_natural && i <= k)
        mirrored[k] = p + 1;
      if (i == k) {
        pivot = values[p];
        continue;
      }
      if (i > k)
        continue;
      row_values[i] = values[p];
      const int column = inner[p]; // the pattern is symmetric
      column_values[i] = values[is_natural ? mirrored[column]++
                                           : std::lower_bound(inner + outer[column],
                                                              inner + outer[column + 1], row) -
                                                 inner];
      int length = 0;
      for (; visited[i] != k; i = parent[i]) {
        path[length++] = i;
        visited[i] = k;
      }
      while (length > 0)
        reach[--top] = path[--length];
    }
    size = std::abs(pivot);
    for (; top < n; ++top) {
      const int i = reach[top];
      const double l = row_values[i], u = column_values[i];
      row_values[i] = column_values[i] = 0.;
      for (std::size_t p = columns[i]; p < end[i]; ++p) {
        row_values[column_rows[p]] -= upper[p] * l;
        column_values[column_rows[p]] -= lower[p] * u;
      }
      const double scaled = l / diagonal[i];
      pivot -= scaled * u;
      size = std::max(size, std::abs(scaled * u));
      lower[end[i]] = scaled;
      upper[end[i]] = u / diagonal[i];
      column_rows[end[i]++] = k;
    }
    if (!(std::abs(pivot) > 1e-15 * size))
      return false;
    diagonal[k] = pivot;
  }
  return true;
}

Vector LineFactorization::solve(const Vector &right_hand_side) const {
  const int n = diagonal.size();
  Vector x(n);
  for (int k = 0; k < n; ++k)
    x[k] = right_hand_side[old_of_new[k]];
  for (int i = 0; i < n; ++i)
    for (std::size_t p = columns[i]; p < columns[i + 1]; ++p)
      x[column_rows[p]] -= lower[p] * x[i];
  for (int i = n - 1; i >= 0; --i) {
    double value = x[i] / diagonal[i];
    for (std::size_t p = columns[i]; p < columns[i + 1]; ++p)
      value -= upper[p] * x[column_rows[p]];
    x[i] = value;
  }
  Vector result(n);
  for (int k = 0; k < n; ++k)
    result[old_of_new[k]] = x[k];
  return result;
}

} // namespace frictionbeam::contact
