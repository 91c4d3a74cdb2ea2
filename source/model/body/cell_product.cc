// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/cell_product.h"

namespace frictionbeam {

namespace {

#if defined(__GNUC__) && defined(__x86_64__)
#define FRICTIONBEAM_TARGET(features) __attribute__((target(features)))
#define FRICTIONBEAM_HAS(feature) __builtin_cpu_supports(feature)
#else
#define FRICTIONBEAM_TARGET(features)
#define FRICTIONBEAM_HAS(feature) false
#endif

/// Blocks of rows, with vectors of @p width bytes.
template <typename Number, unsigned int n_rows, unsigned int n_lanes, unsigned int width>
__attribute__((always_inline)) inline void
multiply_blocks(const Number *K, const unsigned int n_blocks, const unsigned int n, const Number *x,
                Number *y) {
  typedef Number Lanes __attribute__((vector_size(width)));
  constexpr unsigned int of_vector = width / sizeof(Number);
  for (unsigned int block = 0; block < n_blocks; ++block, K += n * n_rows, y += n_rows * n_lanes)
    for (unsigned int first = 0; first < n_lanes; first += of_vector) {
      Lanes sums[n_rows] = {};
      for (unsigned int column = 0; column < n; ++column) {
        const Lanes values = *reinterpret_cast<const Lanes *>(x + column * n_lanes + first);
#pragma GCC unroll 8 // so that the sums stay in registers
        for (unsigned int row = 0; row < n_rows; ++row)
          sums[row] += K[column * n_rows + row] * values;
      }
#pragma GCC unroll 8
      for (unsigned int row = 0; row < n_rows; ++row)
        *reinterpret_cast<Lanes *>(y + row * n_lanes + first) = sums[row];
    }
}

template <typename Number, unsigned int n_rows, unsigned int n_lanes>
FRICTIONBEAM_TARGET("avx512f,fma")
void multiply_by_avx512(const Number *K, const unsigned int n_blocks, const unsigned int n,
                        const Number *x, Number *y) {
  multiply_blocks<Number, n_rows, n_lanes, 64>(K, n_blocks, n, x, y);
}

template <typename Number, unsigned int n_rows, unsigned int n_lanes>
FRICTIONBEAM_TARGET("avx2,fma")
void multiply_by_avx2(const Number *K, const unsigned int n_blocks, const unsigned int n,
                      const Number *x, Number *y) {
  multiply_blocks<Number, n_rows, n_lanes, 32>(K, n_blocks, n, x, y);
}

} // namespace

template <typename Number>
CellProduct<Number>::CellProduct(const dealii::FullMatrix<double> &matrix,
                                 const std::vector<unsigned int> &numbering)
    : n(numbering.size()), n_blocks((n + rows_of_block - 1) / rows_of_block),
      entries(n_blocks * rows_of_block * n, Number(0.)) {
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      entries[(i / rows_of_block * n + j) * rows_of_block + i % rows_of_block] =
          matrix(numbering[i], numbering[j]);
}

template <typename Number>
void CellProduct<Number>::multiply(const Number *const x, Number *const y) const {
  if (FRICTIONBEAM_HAS("avx512f"))
    multiply_by_avx512<Number, rows_of_block, n_lanes>(entries.data(), n_blocks, n, x, y);
  else if (FRICTIONBEAM_HAS("avx2") && FRICTIONBEAM_HAS("fma"))
    multiply_by_avx2<Number, rows_of_block, n_lanes>(entries.data(), n_blocks, n, x, y);
  else
    multiply_blocks<Number, rows_of_block, n_lanes, 16>(entries.data(), n_blocks, n, x, y);
}

template class CellProduct<float>;
template class CellProduct<double>;

} // namespace frictionbeam
