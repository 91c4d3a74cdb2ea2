// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/motion_products.h"

namespace frictionbeam {

namespace {

using Pair = Eigen::Array2d;

Pair pair_at(const double *const numbers) { return Eigen::Map<const Pair>(numbers); }

/// Of n numbers that stand one after the other.
double product_of_run(const double *const a, const double *const b, const int n) {
  Pair sum(0., 0.), other(0., 0.); // which need not wait for each other
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    sum += pair_at(a + k) * pair_at(b + k);
    other += pair_at(a + k + 2) * pair_at(b + k + 2);
  }
  double rest = 0.;
  for (; k < n; ++k)
    rest += a[k] * b[k];
  return (sum + other).sum() + rest;
}

} // namespace

void multiply(const SparseMatrix &matrix, const Vector &vector, Vector &product) {
  Assert(matrix.cols() == vector.size(), dealii::ExcInternalError());
  if (!matrix.isCompressed()) {
    product.noalias() = matrix * vector;
    return;
  }
  const int n_rows = matrix.rows(), *const begin = matrix.outerIndexPtr();
  product.resize(n_rows);
  for (int row = 0; row < n_rows; ++row) {
    const int n = begin[row + 1] - begin[row], *const columns = matrix.innerIndexPtr() + begin[row];
    const double *const values = matrix.valuePtr() + begin[row];
    double sum = 0.;
    if (n > 0 && columns[n - 1] - columns[0] == n - 1) // ascending, each once
      sum = product_of_run(values, vector.data() + columns[0], n);
    else
      for (int k = 0; k < n; ++k)
        sum += values[k] * vector[columns[k]];
    product[row] = sum;
  }
}

} // namespace frictionbeam
