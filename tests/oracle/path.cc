// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path.h"

#include <cmath>

namespace oracle {

Vec Curve::at(const double s) const {
  if (radius == 0.)
    return begin + s * tangent;
  const double angle = s / radius;
  return begin + radius * (std::sin(angle) * tangent + (1. - std::cos(angle)) * inward);
}

Vec Curve::direction(const double s) const {
  if (radius == 0.)
    return tangent;
  return std::cos(s / radius) * tangent + std::sin(s / radius) * inward;
}

Curve Curve::part(const double from, const double to) const {
  Curve result = *this;
  result.begin = at(from);
  result.tangent = direction(from);
  if (radius > 0.)
    result.inward = std::cos(from / radius) * inward - std::sin(from / radius) * tangent;
  result.length = to - from;
  return result;
}

Path::Path(const Pipe &pipe) {
  const auto append = [&](const Curve &curve) {
    start.push_back(length);
    curves.push_back(curve);
    length += curve.length;
  };
  const std::vector<Corner> &route = pipe.route;
  Vec from = route.front().position;
  if (!route.front().name.empty())
    names.emplace_back(route.front().name, 0.);
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Vec corner = route[i].position, t = (corner - from).normalized();
    const double R = route[i].bend;
    const Vec next = i + 1 < route.size() ? Vec((route[i + 1].position - corner).normalized()) : t;
    const double angle = R > 0. ? std::atan2(t.cross(next).norm(), t.dot(next)) : 0.;
    const double cut = R * std::tan(angle / 2.);
    if ((corner - from).norm() - cut > 1e-9) {
      Curve run;
      run.begin = from;
      run.tangent = t;
      run.length = (corner - from).norm() - cut;
      append(run);
    }
    if (angle > 0.) {
      Curve arc;
      arc.begin = corner - cut * t;
      arc.tangent = t;
      arc.inward = (next - next.dot(t) * t).normalized();
      arc.radius = R;
      arc.length = R * angle;
      append(arc);
    }
    from = corner + cut * next;
    if (!route[i].name.empty())
      names.emplace_back(route[i].name, length - (angle > 0. ? R * angle / 2. : 0.));
  }
}

std::size_t Path::curve_at(const double s) const {
  std::size_t i = 0;
  while (i + 1 < curves.size() && s >= start[i + 1])
    ++i;
  return i;
}

Vec Path::at(const double s) const {
  const std::size_t i = curve_at(s);
  return curves[i].at(s - start[i]);
}

} // namespace oracle
