// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/fit_bends.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double rounding = 1e-9; ///< of a leg: no overlap

/// x of A W A^T x = overlap, with a row c_i + c_(i+1) <= L for each active leg, W = diag(c): a
/// tridiagonal matrix.
std::vector<double> multipliers(const std::vector<double> &c, const std::vector<double> &overlap,
                                const std::vector<bool> &active) {
  const unsigned int n = overlap.size();
  std::vector<double> x(n, 0.), above(n, 0.);
  for (unsigned int i = 0; i < n; ++i) {
    if (!active[i])
      continue;
    const bool coupled = i > 0 && active[i - 1];
    const double below = coupled ? c[i] : 0.,
                 pivot = c[i] + c[i + 1] - below * (coupled ? above[i - 1] : 0.);
    above[i] = c[i + 1] / pivot;
    x[i] = (overlap[i] - below * (coupled ? x[i - 1] : 0.)) / pivot;
  }
  for (unsigned int i = n - 1; i-- > 0;)
    if (active[i] && active[i + 1])
      x[i] -= above[i] * x[i + 1];
  return x;
}

} // namespace

double tangent_length(const std::vector<RoutePoint> &route, const unsigned int corner) {
  if (route[corner].bend_radius == 0. || corner == 0 || corner + 1 == route.size())
    return 0.;
  const Vector3 a = route[corner].position - route[corner - 1].position,
                b = route[corner + 1].position - route[corner].position;
  const double cosine = a * b / (a.norm() * b.norm());
  return route[corner].bend_radius * std::sqrt(std::max(0., 1. - cosine) / (1. + cosine));
}

double largest_overlap(const double leg) { return std::min(2e-3, 0.01 * leg); }

std::vector<BendOverlap> fit_bends(std::vector<RoutePoint> &route,
                                   std::optional<BendOverlap> &too_long) {
  const unsigned int n = route.size() - 1;
  std::vector<double> c(n + 1), length(n), overlap(n);
  for (unsigned int i = 0; i <= n; ++i)
    c[i] = tangent_length(route, i);
  std::vector<BendOverlap> found;
  std::vector<bool> active(n, false);
  for (unsigned int i = 0; i < n; ++i) {
    length[i] = route[i].position.distance(route[i + 1].position);
    overlap[i] = c[i] + c[i + 1] - length[i];
    active[i] = overlap[i] > rounding * length[i];
    if (active[i])
      found.push_back({i, overlap[i]});
    if (overlap[i] > std::max(rounding * length[i], largest_overlap(length[i]))) {
      too_long = found.back();
      return {};
    }
  }
  if (found.empty())
    return found;

  // In a chain of bends a shorter one may lengthen the next, which then fills its other leg as
  // well.
  std::vector<double> fitted = c;
  for (bool again = true; again;) {
    again = false;
    const std::vector<double> x = multipliers(c, overlap, active);
    for (unsigned int i = 0; i <= n; ++i)
      fitted[i] =
          c[i] * (1. - (i > 0 && active[i - 1] ? x[i - 1] : 0.) - (i < n && active[i] ? x[i] : 0.));
    for (unsigned int i = 0; i < n; ++i)
      if (!active[i] && fitted[i] + fitted[i + 1] > length[i] * (1. + rounding))
        again = active[i] = true;
  }
  for (unsigned int i = 0; i <= n; ++i)
    if (c[i] > 0.)
      route[i].bend_radius *= fitted[i] / c[i];
  return found;
}

} // namespace frictionbeam
