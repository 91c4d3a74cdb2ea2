// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/sparse_matrix.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace frictionbeam {

void add_to(SparseMatrix &matrix, const int row, const int column, const double value) {
  const int *const begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row];
  const int *const end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row + 1];
  const int *const entry = std::lower_bound(begin, end, column);
  Assert(entry != end && *entry == column, dealii::ExcMessage("The entry is not in the pattern."));
  matrix.valuePtr()[entry - matrix.innerIndexPtr()] += value;
}

} // namespace frictionbeam
