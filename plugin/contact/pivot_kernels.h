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
   * to -= sum over pivots p of (L, U)_p times from_p, two pivots after two.
   * @param from the first pivot's pairs, the first of which has its factors
   * @param n of a row @param size is raised to the largest |L U| of the factors
   */
  void (*subtract)(const double *from, const int stride, const int n_pivots, double *to,
                   const int n, double &size);
  /// L *= factor in a run of n pairs.
  void (*scale)(double *pairs, const int n, const double factor);
  /// L x = b of a block, what its rows below get subtracted.
  void (*solve_lower)(const double *pairs, const int stride, const int width, double *at);
  /// D U x = b of a block, what its columns beyond are multiplied by known.
  void (*solve_upper)(const double *pairs, const int stride, const int width,
                      const double *diagonal, double *at);

  /// Those of this processor.
  static const PivotKernels &best();
};

} // namespace frictionbeam::contact
