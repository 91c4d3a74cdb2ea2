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
    // What is within the tolerance, a quarter of a cell, of a point in the inner half of its cell
    // is in that cell: those beside it are looked into only where the point is further out.
    constexpr double inner = 0.2; // a quarter, and room for rounding
    std::array<long, 3> key, first, last;
    for (unsigned int d = 0; d < 3; ++d) {
      const double place = p[d] / cell;
      key[d] = std::lround(place);
      const double off = place - key[d];
      first[d] = off < -inner ? -1 : 0;
      last[d] = off > inner ? 1 : 0;
    }
    for (long i = first[0]; i <= last[0]; ++i)
      for (long j = first[1]; j <= last[1]; ++j)
        for (long k = first[2]; k <= last[2]; ++k) {
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

/// Those of a list of points that are the same as one before them.
inline std::vector<std::size_t> repeated_points(const std::vector<Point3> &points,
                                                const double tolerance) {
  PointSet places(tolerance);
  std::vector<std::size_t> repeated;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t n_before = places.points.size();
    if (static_cast<std::size_t>(places.insert(points[i])) < n_before)
      repeated.push_back(i);
  }
  return repeated;
}

} // namespace frictionbeam
