// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/sparse_matrix.h"

#include <vector>

namespace frictionbeam {

/**
 * Entries of a sparse matrix as they are found; what stands at one place is added up in that order.
 * Of a line along the axes two thirds of the cells' entries are zeros, and no places of the matrix
 * unless they are asked for.
 */
class MatrixEntries {
public:
  enum class Zeros { left_out, kept };
  /// @param n_expected entries to make room for at once
  explicit MatrixEntries(const Zeros zeros, const std::size_t n_expected = 0)
      : keeps_zeros(zeros == Zeros::kept) {
    entries.reserve(n_expected);
  }

  void add(const int row, const int column, const double value) {
    if (value != 0. || keeps_zeros)
      entries.emplace_back(row, column, value);
  }
  /// Places for entries between these unknowns that come later. @param unknowns each once
  void add_places(const std::vector<int> &unknowns) {
    for (const int row : unknowns)
      for (const int column : unknowns)
        entries.emplace_back(row, column, 0.);
  }

  /// The matrix on @p n unknowns, with its diagonal among the places.
  SparseMatrix matrix(const int n) {
    for (int i = 0; i < n; ++i)
      entries.emplace_back(i, i, 0.);
    SparseMatrix result(n, n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

private:
  bool keeps_zeros;
  std::vector<Eigen::Triplet<double>> entries;
};

} // namespace frictionbeam
