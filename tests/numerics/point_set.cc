// SPDX-License-Identifier: LGPL-2.1-or-later
// A set of points knows each that is within its tolerance of one before, wherever in the cells of
// its grid, against all pairs of points.
#include "../check.h"

#include "mesh/point_set.h"

#include <algorithm>
#include <random>

using namespace frictionbeam;

namespace {

/// @param from the origin, in coordinates [m]
void check_points(const double tolerance, const double from) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> within(0., 30. * tolerance), part(-1.2, 1.2);
  PointSet set(tolerance);
  std::vector<Point3> before;
  unsigned int n_known = 0;
  for (unsigned int n = 0; n < 3000; ++n) {
    Point3 point;
    for (unsigned int d = 0; d < 3; ++d)
      point[d] = from + within(random);
    if (n % 3 > 0) // about as far from one before, along an axis, as the tolerance is
      (point = before[random() % before.size()])[random() % 3] += part(random) * tolerance;
    const std::size_t number = set.insert(point);
    const auto is_same = [&](const Point3 &other) { return other.distance(point) <= tolerance; };
    if (number < before.size()) {
      ++n_known;
      CHECK(is_same(before[number]));
    } else {
      CHECK(number == before.size() && std::none_of(before.begin(), before.end(), is_same));
      before.push_back(point);
    }
    CHECK(set.insert(point) == static_cast<int>(number));
  }
  CHECK(n_known > 500 && set.points.size() == before.size());
}

} // namespace

int point_set(int, char **) {
  check_points(1e-6, 0.);
  check_points(1e-6, -1e5);
  check_points(0.25, 3.);
  return check::report();
}
