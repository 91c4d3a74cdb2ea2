// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/line_mesh.h"

#include <cmath>

namespace frictionbeam {

using namespace dealii;

Vector3 MeshedPipe::tangent(const std::vector<Point3> &points, const unsigned int cell,
                            const bool at_end) const {
  const Point3 begin = points[vertices[cell]], end = points[vertices[cell + 1]];
  Vector3 along = end - begin;
  if (const auto arc = arc_centre.find(cell); arc != arc_centre.end()) {
    const Vector3 axis = cross_product_3d(begin - arc->second, end - arc->second);
    along = cross_product_3d(axis, (at_end ? end : begin) - arc->second);
  } else if (const auto bend = bend_axis.find(cell); bend != bend_axis.end()) {
    // A chord of the bend, turned to its tangent by half the angle, sin(angle/2) = chord/(2 R).
    const double sine = std::min(1., along.norm() / (2. * bend_radius[cell]));
    along = std::sqrt(1. - sine * sine) * along +
            (at_end ? sine : -sine) * cross_product_3d(bend->second, along);
  }
  return along / along.norm();
}

} // namespace frictionbeam
