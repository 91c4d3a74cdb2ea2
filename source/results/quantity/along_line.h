// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <vector>

namespace frictionbeam {

/// The coordinate in which points extend furthest; of equal ones the first.
template <typename Rows>
unsigned int long_axis(const Rows &rows) {
  unsigned int longest = 0;
  double extent = 0.;
  for (unsigned int d = 0; d < 3; ++d) {
    const auto [least, most] =
        std::minmax_element(rows.begin(), rows.end(), [d](const auto &a, const auto &b) {
          return a.position[d] < b.position[d];
        });
    if (least != rows.end() && most->position[d] - least->position[d] > (1. + 1e-9) * extent) {
      extent = most->position[d] - least->position[d];
      longest = d;
    }
  }
  return longest;
}

/// How far each of some rows is from the first, along the straight line from there to the first of
/// the last ones; the rows are in the order of their long_axis() [m].
template <typename Rows>
std::vector<double> along_line(const Rows &rows) {
  const unsigned int axis = long_axis(rows);
  const auto last =
      std::max_element(rows.begin(), rows.end(), [axis](const auto &a, const auto &b) {
        return a.position[axis] < b.position[axis];
      });
  std::vector<double> distances(rows.size(), 0.);
  if (rows.empty())
    return distances;
  const Point3 begin = rows.front().position;
  const Vector3 whole = last->position - begin;
  const double length = whole.norm();
  for (std::size_t i = 0; i < rows.size() && length > 0.; ++i)
    distances[i] = (rows[i].position - begin) * whole / length;
  return distances;
}

} // namespace frictionbeam
