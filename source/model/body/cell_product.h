// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/full_matrix.h>

namespace frictionbeam {

/**
 * y = K x for many cells that have the same matrix K, some at a time, each in a lane of the
 * processor's vectors (SSE2, AVX2 or AVX-512, as the processor has them: deal.II of a distribution
 * is compiled for none of them). Entry i of the cell in lane l is x[i * n_lanes + l].
 */
template <typename Number>
class CellProduct {
public:
  static constexpr unsigned int bytes = 64, n_lanes = bytes / sizeof(Number);

  /// Row i and column i of K are those of @p numbering [i] in @p matrix.
  CellProduct(const dealii::FullMatrix<double> &matrix, const std::vector<unsigned int> &numbering);
  /// All lanes; x and y aligned to 64 bytes, y with room for padded_size() rows
  void multiply(const Number *const x, Number *const y) const;
  unsigned int padded_size() const { return rows_of_block * n_blocks; }

private:
  static constexpr unsigned int rows_of_block = 8; ///< sums that registers hold at a time
  const unsigned int n, n_blocks;
  dealii::AlignedVector<Number> entries; ///< by block, column and row in the block
};

} // namespace frictionbeam
