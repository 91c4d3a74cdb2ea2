// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/sparse_matrix.h"

#include <vector>

namespace frictionbeam {

/// Sets of unknowns, those of one set coupled with each other: the pattern of a sparse matrix.
class Couplings {
public:
  /// @param unknowns each once, in any order
  void add(const std::vector<int> &unknowns);

  /// A matrix of zeros on @p n unknowns, with the diagonal in its pattern.
  SparseMatrix matrix(const int n) const;

private:
  std::vector<std::size_t> start{0};
  std::vector<int> members; ///< of one set after the other
};

} // namespace frictionbeam
