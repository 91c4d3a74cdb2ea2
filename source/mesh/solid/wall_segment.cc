// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/solid/wall_segment.h"

#include <cmath>

namespace frictionbeam {

using namespace dealii;

Vector3 WallSegment::carried(const Vector3 &direction, const double s) const {
  if (path.radius == 0.)
    return direction;
  const double angle = s / path.radius;
  const Vector3 axis = cross_product_3d(path.first_tangent, path.inward);
  return (direction * axis) * axis +
         (direction * path.inward) *
             (std::cos(angle) * path.inward - std::sin(angle) * path.first_tangent);
}

} // namespace frictionbeam
