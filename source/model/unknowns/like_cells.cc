// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/like_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace frictionbeam {

namespace {

/// By how much the lengths of two cells may differ whose vertices are rounded: half a unit of the
/// last place in each coordinate.
double rounding(const Point3 &begin, const Point3 &end) {
  double largest = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    largest = std::max({largest, std::abs(begin[d]), std::abs(end[d])});
  return 4. * std::numeric_limits<double>::epsilon() * largest;
}

} // namespace

std::vector<unsigned int> first_like_cells(const std::vector<Point3> &points,
                                           const std::vector<LineCell> &cells) {
  std::map<std::pair<unsigned int, double>, unsigned int> known; // by section and length
  std::vector<unsigned int> first;
  for (unsigned int i = 0; i < cells.size(); ++i) {
    const Point3 &begin = points[cells[i].vertices[0]], &end = points[cells[i].vertices[1]];
    const double length = begin.distance(end), tolerance = rounding(begin, end);
    auto like = known.lower_bound({cells[i].material_id, length - tolerance});
    if (like == known.end() || like->first.first != cells[i].material_id ||
        like->first.second > length + tolerance)
      like = known.emplace_hint(like, std::make_pair(cells[i].material_id, length), i);
    first.push_back(like->second);
  }
  return first;
}

} // namespace frictionbeam
