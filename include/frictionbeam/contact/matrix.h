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

// Eigen's objects pass between a program and the library, so that both must align and allocate them
// alike: -march=native, -mavx or -fsanitize=address let Eigen do so otherwise. The alignment is
// defined by the library's targets where it was built with such flags.
#ifdef FRICTIONBEAM_EIGEN_ALIGNMENT
static_assert(
    EIGEN_DEFAULT_ALIGN_BYTES == FRICTIONBEAM_EIGEN_ALIGNMENT && !EIGEN_MALLOC_ALREADY_ALIGNED,
#else
static_assert(
    EIGEN_DEFAULT_ALIGN_BYTES == 16 && EIGEN_MALLOC_ALREADY_ALIGNED,
#endif
    "Eigen aligns or allocates otherwise here than in the library of exact contact, and the "
    "program would crash. Build FrictionBeam with this program's flags "
    "(-DCMAKE_CXX_FLAGS=-march=native), or this file without -march, -mavx; with "
    "-fsanitize=address alone, add -DEIGEN_MALLOC_ALREADY_ALIGNED=1");

using Vector = Eigen::VectorXd;
/// Both entries of a pair (i, j), (j, i) are in the pattern, and columns of a row are sorted.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// Add to an entry that the matrix's pattern has.
void add_to(SparseMatrix &matrix, const int row, const int column, const double value);

} // namespace frictionbeam::contact
