// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>

namespace frictionbeam::section {

/**
 * A symmetric matrix of at most `most` rows whose first unknowns are eliminated: L D L^T without
 * pivots, good for definite matrices and for those of the form (K, c; c^T, -b) with definite K, b.
 */
template <int most>
class SymmetricSystem {
public:
  explicit SymmetricSystem(const int n) : n(n) {
    for (int i = 0; i < n; ++i)
      std::fill(matrix[i], matrix[i] + n, 0.);
  }

  /// Entry of the lower triangle, row >= column. Of the rows that are left after eliminate(): their
  /// Schur complement.
  double &operator()(const int row, const int column) { return matrix[row][column]; }
  double operator()(const int row, const int column) const { return matrix[row][column]; }

  /// @return whether the first @p n_definite pivots are positive, the others negative.
  bool eliminate(const int n_eliminated, const int n_definite) {
    n_first = n_eliminated;
    for (int j = 0; j < n; ++j) {
      double *const row = matrix[j];
      for (int i = 0; i < j; ++i)
        for (int k = 0; k < std::min(i, n_first); ++k)
          row[i] -= row[k] * matrix[i][k];
      for (int i = 0; i < std::min(j, n_first); ++i) { // of L D, then of L
        const double of_LD = row[i];
        row[i] /= pivot[i];
        row[j] -= row[i] * of_LD;
      }
      if (j < n_first) {
        pivot[j] = row[j];
        if (!(j < n_definite ? row[j] > 0. : row[j] < 0.))
          return false;
      }
    }
    return true;
  }

  /// Of the unknowns that are eliminated, the others zero.
  void solve(double *const x) const {
    for (int i = 0; i < n_first; ++i)
      for (int k = 0; k < i; ++k)
        x[i] -= matrix[i][k] * x[k];
    for (int i = 0; i < n_first; ++i)
      x[i] /= pivot[i];
    for (int i = n_first - 1; i >= 0; --i)
      for (int k = i + 1; k < n_first; ++k)
        x[i] -= matrix[k][i] * x[k];
  }

private:
  int n, n_first = 0;
  double matrix[most][most], pivot[most];
};

} // namespace frictionbeam::section
