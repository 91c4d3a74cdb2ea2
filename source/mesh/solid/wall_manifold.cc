// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/solid/wall_manifold.h"

#include <cmath>

namespace frictionbeam {

using namespace dealii;

WallManifold::WallManifold(const WallSegment &segment)
    : ChartManifold<3, 3, 3>(Tensor<1, 3>({0., 2. * numbers::PI, 0.})), segment(segment) {}

std::unique_ptr<Manifold<3, 3>> WallManifold::clone() const {
  return std::make_unique<WallManifold>(segment);
}

Point<3> WallManifold::pull_back(const Point<3> &place) const {
  const PipePath::Segment &path = segment.path;
  double s = (place - path.begin) * path.first_tangent;
  if (path.radius > 0.) {
    const Vector3 arm = place - path.centre;
    s = path.radius * std::atan2(arm * path.first_tangent, -(arm * path.inward));
  }
  const Vector3 arm = place - path.point(s);
  double angle = std::atan2(arm * segment.carried(segment.b, s), arm * segment.carried(segment.a, s));
  if (angle < 0.)
    angle += 2. * numbers::PI;
  return {s, angle, arm.norm()};
}

Point<3> WallManifold::push_forward(const Point<3> &chart) const {
  const double s = chart[0];
  return segment.path.point(s) + chart[2] * (std::cos(chart[1]) * segment.carried(segment.a, s) +
                                             std::sin(chart[1]) * segment.carried(segment.b, s));
}

} // namespace frictionbeam
