// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam::contact {

/**
 * Inner loops of BlockFactorization on a block's rows of pairs (U, L), which follow each other at
 * a stride (counted in pairs), four numbers at a time where the processor has AVX2. All processors
 * make the same numbers: none joins a product and a sum into one rounding.
 */
struct PivotKernels {
  /**
   * From rows one after the other, the first n pairs of which end where those of the block do:
   * to -= sum over pivots p of (L, U)_p times from_p, two pivots after two.
   * @param from the first pivot's pairs, which begin with its factors of the first row
   * @param to diagonal of the first row
   * @param size of each row: raised to the largest |L U| of its factors
   */
  void (*subtract)(const double *from, const int stride_of_from, const int n_pivots, double *to,
                   const int stride, const int n_rows, const int n, double *size);
  /// Eliminate a block's own columns, from which all earlier ones are subtracted.
  /// @param share is lowered to what is left of a pivot
  /// @return false if one vanishes
  bool (*eliminate)(double *pairs, const int stride, const int width, double *size,
                    double *diagonal, double &share);
  /// L x = b of a block, what its rows below get subtracted.
  void (*solve_lower)(const double *pairs, const int stride, const int width, double *at);
  /// D U x = b of a block, what its columns beyond are multiplied by known.
  void (*solve_upper)(const double *pairs, const int stride, const int width,
                      const double *diagonal, double *at);

  /// Those of this processor.
  static const PivotKernels &best();
};

} // namespace frictionbeam::contact
