// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pivot_kernels.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::contact {

namespace {

using TwoNumbers = double __attribute__((vector_size(16)));
using FourNumbers = double __attribute__((vector_size(32)));

constexpr int most_pivots = 6; ///< at once: unknowns of a node, and an even number

/// Numbers that lie at any double in memory, which knows of nothing but doubles.
template <typename Numbers>
struct __attribute__((packed, may_alias)) Unaligned {
  Numbers all;
};

template <typename Numbers>
[[gnu::always_inline]] inline const Unaligned<Numbers> &at(const double *const place) {
  return *reinterpret_cast<const Unaligned<Numbers> *>(place);
}

template <typename Numbers>
[[gnu::always_inline]] inline Unaligned<Numbers> &at(double *const place) {
  return *reinterpret_cast<Unaligned<Numbers> *>(place);
}

template <typename Numbers, int n_pivots>
[[gnu::always_inline]] inline void subtract_from(const double *const *const from, const int k,
                                                 const double (*const factor)[4],
                                                 double *const to) {
  Numbers left = at<Numbers>(to + k).all;
#pragma GCC unroll 6
  for (int p = 0; p + 1 < n_pivots; p += 2)
    left -= at<Numbers>(factor[p]).all * at<Numbers>(from[p] + k).all +
            at<Numbers>(factor[p + 1]).all * at<Numbers>(from[p + 1] + k).all;
  if (n_pivots % 2 != 0)
    left -= at<Numbers>(factor[n_pivots - 1]).all * at<Numbers>(from[n_pivots - 1] + k).all;
  at<Numbers>(to + k).all = left;
}

template <int n_pivots>
[[gnu::always_inline]] inline void subtract_some(const double *const first, const int stride,
                                                 double *const to, const int n, double &size) {
  const double *from[n_pivots];
  double reversed[n_pivots][4];
  double largest = size;
#pragma GCC unroll 6
  for (int p = 0; p < n_pivots; ++p) {
    from[p] = first + p * stride;
    const double u = from[p][0], l = from[p][1];
    reversed[p][0] = reversed[p][2] = l;
    reversed[p][1] = reversed[p][3] = u;
    largest = std::max(largest, std::abs(l * u));
  }
  size = largest;
  int k = 0;
  for (; k + 2 < 2 * n; k += 4)
    subtract_from<FourNumbers, n_pivots>(from, k, reversed, to);
  if (k < 2 * n)
    subtract_from<TwoNumbers, n_pivots>(from, k, reversed, to);
}

[[gnu::always_inline]] inline void subtract_row(const double *from, const int stride_of_pairs,
                                                int n_pivots, double *to, const int n,
                                                double &size) {
  const int stride = 2 * stride_of_pairs;
  for (; n_pivots >= most_pivots; n_pivots -= most_pivots, from += most_pivots * stride)
    subtract_some<most_pivots>(from, stride, to, n, size);
  switch (n_pivots) {
  case 1:
    return subtract_some<1>(from, stride, to, n, size);
  case 2:
    return subtract_some<2>(from, stride, to, n, size);
  case 3:
    return subtract_some<3>(from, stride, to, n, size);
  case 4:
    return subtract_some<4>(from, stride, to, n, size);
  case 5:
    return subtract_some<5>(from, stride, to, n, size);
  }
}

[[gnu::always_inline]] inline void scale_all(double *const pairs, const int n,
                                             const double factor) {
  int k = 0;
  for (; k + 1 < n; k += 2)
    at<FourNumbers>(pairs + 2 * k).all *= FourNumbers{1., factor, 1., factor};
  if (k < n)
    pairs[2 * k + 1] *= factor;
}

[[gnu::always_inline]] inline void subtract_rows(const double *from, const int stride_of_from,
                                                 const int n_pivots, double *to, const int stride,
                                                 const int n_rows, const int n, double *size) {
  for (int row = 0; row < n_rows; ++row, from += 2, to += 2 * (stride + 1))
    subtract_row(from, stride_of_from, n_pivots, to, n - row, size[row]);
}

[[gnu::always_inline]] inline bool eliminate_block(double *const pairs, const int stride,
                                                   const int width, double *const size,
                                                   double *const diagonal, double &share) {
  constexpr double vanishing = 1e-15; // of what was subtracted from it
  for (int i = 0; i < width; ++i) {
    double *const row = pairs + 2 * i * (stride + 1);
    if (i > 0)
      subtract_row(pairs + 2 * i, stride, i, row, stride - i, size[i]);
    const double pivot = row[0];
    if (!(std::abs(pivot) > vanishing * size[i]))
      return false;
    diagonal[i] = pivot;
    share = std::min(share, std::abs(pivot) / size[i]);
    scale_all(row + 2, stride - i - 1, 1. / pivot);
  }
  return true;
}

[[gnu::always_inline]] inline void solve_lower_of(const double *const pairs, const int stride,
                                                  const int width, double *const x) {
  const double *row = pairs;
  for (int p = 0; p < width; ++p, row += 2 * stride)
    for (int k = p + 1; k < width; ++k)
      x[k] -= row[2 * k + 1] * x[p];
  int k = width;
  for (; k + 3 < stride; k += 4) {
    const FourNumbers before = at<FourNumbers>(x + k).all;
    FourNumbers left = __builtin_shufflevector(before, before, 0, 2, 1, 3);
    row = pairs + 2 * k;
    for (int p = 0; p < width; ++p, row += 2 * stride) {
      const FourNumbers L = __builtin_shufflevector(at<FourNumbers>(row).all,
                                                    at<FourNumbers>(row + 4).all, 1, 5, 3, 7);
      left -= L * FourNumbers{x[p], x[p], x[p], x[p]};
    }
    at<FourNumbers>(x + k).all = __builtin_shufflevector(left, left, 0, 2, 1, 3);
  }
  for (; k < stride; ++k) {
    double left = x[k];
    row = pairs + 2 * k + 1;
    for (int p = 0; p < width; ++p, row += 2 * stride)
      left -= *row * x[p];
    x[k] = left;
  }
}

[[gnu::always_inline]] inline void solve_upper_of(const double *const pairs, const int stride,
                                                  const int width, const double *const diagonal,
                                                  double *const x) {
  const double *row = pairs;
  for (int p = 0; p < width; ++p, row += 2 * stride) { // what is known, row by row for itself
    FourNumbers sum = {0., 0., 0., 0.};
    int k = width;
    for (; k + 1 < stride; k += 2)
      sum += at<FourNumbers>(row + 2 * k).all * FourNumbers{x[k], x[k], x[k + 1], x[k + 1]};
    if (k < stride)
      sum[0] += row[2 * k] * x[k];
    x[p] -= sum[0] + sum[2];
  }
  for (int p = width - 1; p >= 0; --p) {
    row = pairs + 2 * p * stride;
    double value = x[p];
    for (int k = p + 1; k < width; ++k)
      value -= row[2 * k] * x[k];
    x[p] = value / diagonal[p];
  }
}

void subtract(const double *from, const int stride_of_from, const int n_pivots, double *to,
              const int stride, const int n_rows, const int n, double *size) {
  subtract_rows(from, stride_of_from, n_pivots, to, stride, n_rows, n, size);
}

bool eliminate(double *pairs, const int stride, const int width, double *size, double *diagonal,
               double &share) {
  return eliminate_block(pairs, stride, width, size, diagonal, share);
}

void solve_lower(const double *pairs, const int stride, const int width, double *x) {
  solve_lower_of(pairs, stride, width, x);
}

void solve_upper(const double *pairs, const int stride, const int width, const double *diagonal,
                 double *x) {
  solve_upper_of(pairs, stride, width, diagonal, x);
}

#ifdef __x86_64__
#define FRICTIONBEAM_WIDE __attribute__((target("avx2")))

FRICTIONBEAM_WIDE void subtract_wide(const double *from, const int stride_of_from,
                                     const int n_pivots, double *to, const int stride,
                                     const int n_rows, const int n, double *size) {
  subtract_rows(from, stride_of_from, n_pivots, to, stride, n_rows, n, size);
}

FRICTIONBEAM_WIDE bool eliminate_wide(double *pairs, const int stride, const int width,
                                      double *size, double *diagonal, double &share) {
  return eliminate_block(pairs, stride, width, size, diagonal, share);
}

FRICTIONBEAM_WIDE void solve_lower_wide(const double *pairs, const int stride, const int width,
                                        double *x) {
  solve_lower_of(pairs, stride, width, x);
}

FRICTIONBEAM_WIDE void solve_upper_wide(const double *pairs, const int stride, const int width,
                                        const double *diagonal, double *x) {
  solve_upper_of(pairs, stride, width, diagonal, x);
}
#endif

PivotKernels choose() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2"))
    return {subtract_wide, eliminate_wide, solve_lower_wide, solve_upper_wide};
#endif
  return {subtract, eliminate, solve_lower, solve_upper};
}

} // namespace

const PivotKernels &PivotKernels::best() {
  static const PivotKernels kernels = choose();
  return kernels;
}

} // namespace frictionbeam::contact
