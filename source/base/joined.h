// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <numeric>
#include <vector>

namespace frictionbeam {

/// Numbers that are joined into groups, two at a time.
class Joined {
public:
  explicit Joined(const unsigned int n) : parent(n) { std::iota(parent.begin(), parent.end(), 0u); }

  /// The member that stands for the group of @p i.
  unsigned int find(unsigned int i) {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  }
  void join(const unsigned int a, const unsigned int b) { parent[find(a)] = find(b); }

private:
  std::vector<unsigned int> parent;
};

} // namespace frictionbeam
