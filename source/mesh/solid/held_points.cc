// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/solid/held_points.h"

#include "base/algebra/dense_algebra.h"

namespace frictionbeam {

PipeWall with_held_points(PipeWall wall) {
  const WallRing &ring = wall.rings.front();
  std::vector<Point3> places;
  for (unsigned int i = 0; i < 4; ++i)
    places.push_back(wall.mesh.vertices[i * wall.around / 4]);
  Eigen::Matrix<double, 6, 12> motions;
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int d = 0; d < 3; ++d) {
      Vector3 direction;
      direction[d] = 1.;
      const Vector3 arm = (places[i] - ring.centre) / wall.outer,
                    turn = cross_product_3d(arm, direction);
      for (unsigned int k = 0; k < 3; ++k) {
        motions(k, 3 * i + d) = direction[k];
        motions(3 + k, 3 * i + d) = turn[k];
      }
    }
  const Eigen::VectorXi columns = most_independent_columns(motions);
  for (unsigned int i = 0; i < 6; ++i) {
    const unsigned int column = columns[i];
    wall.mesh
        .points["held " + std::to_string(column / 3) + " along " + std::to_string(column % 3)] =
        places[column / 3];
  }
  return wall;
}

std::vector<ContinuumHold> holds_at_points(const PipeWall &wall) {
  std::vector<ContinuumHold> holds;
  for (const auto &entry : wall.mesh.points) {
    const unsigned int direction = entry.first.back() - '0';
    holds.push_back({entry.first, {}});
    holds.back().fixed[direction] = true;
  }
  return holds;
}

} // namespace frictionbeam
