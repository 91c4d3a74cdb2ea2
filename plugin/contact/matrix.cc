// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/matrix.h>

#include <algorithm>
#include <cassert>

namespace frictionbeam::contact {

void add_to(SparseMatrix &matrix, const int row, const int column, const double value) {
  const int *const begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row];
  const int *const end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[row + 1];
  const int *const entry = std::lower_bound(begin, end, column);
  assert(entry != end && *entry == column && "the entry is not in the pattern");
  matrix.valuePtr()[entry - matrix.innerIndexPtr()] += value;
}

} // namespace frictionbeam::contact
