// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/couplings.h"

#include <algorithm>
#include <numeric>

namespace frictionbeam {

void Couplings::add(const std::vector<int> &unknowns) {
  members.insert(members.end(), unknowns.begin(), unknowns.end());
  start.push_back(members.size());
}

SparseMatrix Couplings::matrix(const int n) const {
  // The sets of each unknown, row-compressed.
  std::vector<std::size_t> first(n + 1, 0);
  for (const int unknown : members)
    ++first[unknown + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<unsigned int> sets(members.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (unsigned int set = 0; set + 1 < start.size(); ++set)
    for (std::size_t i = start[set]; i < start[set + 1]; ++i)
      sets[next[members[i]]++] = set;

  // Unknowns side by side are most often in the same sets, so that their rows are alike.
  std::vector<int> columns, row; // of all rows that are not like those above, of the last one
  std::vector<std::size_t> begin_of_row(n);
  SparseMatrix result(n, n);
  for (int i = 0; i < n; ++i) {
    const auto own = sets.begin() + first[i], end = sets.begin() + first[i + 1];
    const bool is_alike =
        i > 0 && own != end && std::equal(sets.begin() + first[i - 1], own, own, end);
    if (is_alike)
      begin_of_row[i] = begin_of_row[i - 1];
    else {
      row.assign(1, i);
      for (auto set = own; set != end; ++set)
        row.insert(row.end(), members.begin() + start[*set], members.begin() + start[*set + 1]);
      std::sort(row.begin(), row.end());
      row.erase(std::unique(row.begin(), row.end()), row.end());
      begin_of_row[i] = columns.size();
      columns.insert(columns.end(), row.begin(), row.end());
    }
    result.outerIndexPtr()[i + 1] = result.outerIndexPtr()[i] + row.size();
  }
  result.resizeNonZeros(result.outerIndexPtr()[n]);
  for (int i = 0; i < n; ++i)
    std::copy_n(columns.begin() + begin_of_row[i],
                result.outerIndexPtr()[i + 1] - result.outerIndexPtr()[i],
                result.innerIndexPtr() + result.outerIndexPtr()[i]);
  std::fill_n(result.valuePtr(), result.nonZeros(), 0.);
  return result;
}

} // namespace frictionbeam
