// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line/point_loads.h"

namespace frictionbeam {

std::map<unsigned int, Motion> point_loads(const Scene &scene, const LineMesh &mesh,
                                           const Load &load) {
  std::map<unsigned int, Motion> result;
  if (load.kind == Load::Kind::force)
    for (const Load::AtPoint &at : load.at)
      for (unsigned int c = 0; c < 6; ++c)
        result[mesh.points.at(at.point)][c] += at.value[c];
  if (load.kind == Load::Kind::weight)
    for (const PointMass &mass : scene.masses)
      for (const std::string &point : mass.points)
        for (unsigned int d = 0; d < 3; ++d)
          result[mesh.points.at(point)][d] += mass.mass * load.vector[d];
  if (load.kind == Load::Kind::preload)
    for (const Spring &spring : scene.springs)
      for (unsigned int d = 0; d < 3 && spring.preload != 0.; ++d)
        result[mesh.points.at(spring.point)][d] += spring.directions[2][d] * spring.preload;
  return result;
}

} // namespace frictionbeam
