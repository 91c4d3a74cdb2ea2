// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/network.h"

#include <cmath>

namespace frictionbeam::import {

namespace {
constexpr double grid = 1e9; ///< of written co-ordinates [1/m]
}

Point3 on_grid(const Point3 &point) {
  Point3 result;
  for (unsigned int d = 0; d < 3; ++d)
    result[d] = std::round(point[d] * grid) / grid;
  return result;
}

std::vector<std::vector<std::size_t>> Network::pieces_at() const {
  std::vector<std::vector<std::size_t>> result(nodes.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    result[pieces[i].from].push_back(i);
    result[pieces[i].to].push_back(i);
  }
  return result;
}

} // namespace frictionbeam::import
