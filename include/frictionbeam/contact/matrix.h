// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

/**
 * @file
 * Exact contact for any linear or linearized system. These headers need Eigen and no deal.II, but
 * for deal_ii.h, which takes what a program of deal.II has.
 */
namespace frictionbeam::contact {

using Vector = Eigen::VectorXd;
/// Both entries of a pair (i, j), (j, i) are in the pattern, and columns of a row are sorted.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// Add to an entry that the matrix's pattern has.
void add_to(SparseMatrix &matrix, const int row, const int column, const double value);

} // namespace frictionbeam::contact
