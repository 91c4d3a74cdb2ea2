// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/SparseCore>

namespace frictionbeam {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// Add to an entry that the matrix's pattern has.
void add_to(SparseMatrix &matrix, const int row, const int column, const double value);

} // namespace frictionbeam
