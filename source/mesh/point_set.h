// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace frictionbeam {

/// Points that are the same within a tolerance get one number.
class PointSet {
public:
  explicit PointSet(const double tolerance) : cell(4. * tolerance), tolerance(tolerance) {}

  int insert(const Point3 &p) {
    std::array<long, 3> key;
    for (unsigned int d = 0; d < 3; ++d)
      key[d] = std::lround(p[d] / cell);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto range = grid.equal_range(hash({key[0] + i, key[1] + j, key[2] + k}));
          for (auto it = range.first; it != range.second; ++it)
            if (points[it->second].distance(p) <= tolerance)
              return it->second;
        }
    grid.emplace(hash(key), points.size());
    points.push_back(p);
    return points.size() - 1;
  }

  std::vector<Point3> points;

private:
  static std::size_t hash(const std::array<long, 3> &key) {
    return key[0] * 73856093ul ^ key[1] * 19349663ul ^ key[2] * 83492791ul;
  }

  const double cell, tolerance;
  std::unordered_multimap<std::size_t, int> grid;
};

} // namespace frictionbeam
