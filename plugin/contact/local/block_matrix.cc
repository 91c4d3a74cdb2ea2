// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_matrix.h"

#include <algorithm>

namespace frictionbeam::contact {

template <int d>
BlockMatrix<d>::BlockMatrix(const Eigen::SparseMatrix<double> &matrix) {
  // Rounding may have left it, and its pattern, not quite symmetric.
  const Eigen::SparseMatrix<double> transposed = matrix.transpose(), W = (matrix + transposed) / 2.;
  const int n = W.cols() / d;
  std::vector<int> place(n, -1), touched;
  begins.push_back(0);
  for (int i = 0; i < n; ++i) {
    touched.assign(1, i);
    place[i] = 0;
    const int *const inner = W.innerIndexPtr();
    for (int column = d * i; column < d * (i + 1); ++column)
      for (int k = W.outerIndexPtr()[column]; k < W.outerIndexPtr()[column + 1]; ++k)
        if (const int j = inner[k] / d; place[j] < 0 && W.valuePtr()[k] != 0.) {
          place[j] = 0;
          touched.push_back(j);
        }
    std::sort(touched.begin(), touched.end());
    for (const int j : touched) {
      if (j == i)
        diagonals.push_back(columns.size());
      place[j] = columns.size();
      columns.push_back(j);
      blocks.push_back(Block::Zero());
    }
    for (int c = 0; c < d; ++c) // a column is the row of its place, by symmetry
      for (int k = W.outerIndexPtr()[d * i + c]; k < W.outerIndexPtr()[d * i + c + 1]; ++k)
        if (const int j = inner[k] / d; place[j] >= 0)
          blocks[place[j]](c, inner[k] - d * j) += W.valuePtr()[k];
    for (const int j : touched)
      place[j] = -1;
    begins.push_back(columns.size());
  }
}

template <int d>
Eigen::VectorXd BlockMatrix<d>::times(const Eigen::VectorXd &r) const {
  Eigen::VectorXd result(r.size());
  for (int i = 0; i < n_rows(); ++i)
    result.segment<d>(d * i) = row_times(i, r);
  return result;
}

template class BlockMatrix<2>;
template class BlockMatrix<3>;

} // namespace frictionbeam::contact
