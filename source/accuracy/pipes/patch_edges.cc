// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/pipes/patch_edges.h"

#include "mesh/build_line_mesh.h"
#include "mesh/support/edges_of_patch.h"
#include "scene/support_pair.h"

#include <algorithm>

namespace frictionbeam::accuracy {

namespace {

/// Tangent of the pipe that a place is on; nothing where it is on none.
std::optional<Vector3> tangent_at(const Scene &scene, const std::vector<PipePath> &paths,
                                  const Point3 &position) {
  for (unsigned int p = 0; p < paths.size(); ++p) {
    const double tolerance = 1e-3 * scene.sections[scene.pipes[p].section].outer_radius;
    for (const PipePath::Segment &segment : paths[p].segments())
      if (const auto s = segment.place(position, tolerance))
        return segment.tangent(*s - segment.start);
  }
  return {};
}

/// Beside the wall's stiffness k over a width w, k w^2/12, what holds the rotation is as much as
/// that times 4.5 (r/t = 17; measured, doc/solid.md): what one edge is pressed and the other
/// relieved by, bends the wall nearby only.
Spring spring_of_edges(const WallAtSupport &wall, const SupportInfo &info, const Vector3 &tangent,
                       const double width) {
  constexpr double of_edges = 4.5;
  const Vector3 axis = dealii::cross_product_3d(tangent, info.normal);
  Spring spring;
  spring.name = spring.point = "edges of " + info.name;
  spring.stiffness[3] = of_edges * wall.stiffness * width * width / 12.;
  spring.directions[3] = {{0., 0., 0., axis[0], axis[1], axis[2]}};
  return spring;
}

} // namespace

std::vector<unsigned int> supports_with_edges(const Scene &scene, const WallsAtSupports &walls) {
  std::vector<unsigned int> result;
  const LineMesh mesh = build_line_mesh(scene);
  for (const WallAtSupport &wall : walls.walls)
    if (!is_of_a_pair(scene.supports[wall.support].kind) &&
        have_edges(scene, mesh, scene.supports[wall.support], mesh.supports[wall.support]))
      result.push_back(wall.support);
  return result;
}

Scene on_edges(Scene scene, const std::vector<unsigned int> &supports) {
  for (const unsigned int support : supports)
    scene.supports[support].on_edges = true;
  return scene;
}

Scene with_edges(Scene scene, const WallsAtSupports &walls, const Results &results) {
  const std::vector<unsigned int> supports = supports_with_edges(scene, walls);
  scene = on_edges(std::move(scene), supports);
  const std::vector<PipePath> paths = paths_of(scene);
  for (const WallAtSupport &wall : walls.walls) {
    const FrictionSupport &support = scene.supports[wall.support];
    if (support.on_edges)
      continue;
    const double width = support.width > 0. ? support.width : 2. * wall.radius;
    for (const SupportInfo *const info : places_of(support, results))
      if (const auto tangent = tangent_at(scene, paths, info->position)) {
        scene.springs.push_back(spring_of_edges(wall, *info, *tangent, width));
        scene.add_point(scene.springs.back().point, info->position);
      }
  }
  return scene;
}

} // namespace frictionbeam::accuracy
