// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/sparse_matrix.h"

#include <cstdint>
#include <vector>

namespace frictionbeam {

/**
 * Which zeros were left out of a matrix's pattern. Two thirds of a line's stiffness along the axes
 * are zeros. No product needs them, but orders of elimination, and so the last digits of results,
 * follow from the whole pattern; it takes a fifteenth of the matrix's memory here, for unknowns of
 * one node have the same columns, most of them one after the other.
 */
class ZerosLeftOut {
public:
  /// Leave the zeros of @p matrix out of it.
  explicit ZerosLeftOut(SparseMatrix &matrix);

  /// The matrix with all of its places again. @param matrix as it was left
  SparseMatrix restored(const SparseMatrix &matrix) const;

  /// right_hand_side - matrix (unknowns + low) in extended precision, to the last bit as
  /// contact::unbalanced_forces() has it of the whole matrix. @param matrix as it was left
  Vector unbalanced(const SparseMatrix &matrix, const Vector &right_hand_side,
                    const Vector &unknowns, const Vector &low) const;

private:
  struct Run {
    int begin, end; ///< columns
  };
  /// Rows one after the other with the same columns.
  struct Rows {
    int begin;
    std::uint32_t first; ///< of their runs
  };

  std::vector<Run> runs;
  std::vector<Rows> rows;
  /// Of each entry that is left: whether its place in its row, zeros counted, is the second, fourth
  /// and so on.
  std::vector<bool> at_even_place;
};

} // namespace frictionbeam
