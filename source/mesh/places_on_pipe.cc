// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/places_on_pipe.h"

namespace frictionbeam {

std::vector<double> places_of(const Scene &scene, const PipePath &path, const std::string &point,
                              const double tolerance) {
  for (const PipePath::RoutePlace &place : path.route_points())
    if (place.name == point)
      return {place.s};
  for (const NamedPoint &named : scene.points)
    if (named.name == point)
      return path.all_places(named.position, tolerance);
  return {};
}

std::vector<double> places_of_anchors(const Scene &scene, const PipePath &path,
                                      const double tolerance) {
  std::vector<double> places;
  for (const Restraint &restraint : scene.restraints)
    if (restraint.is_anchor())
      for (const std::string &point : restraint.placement.points)
        for (const double s : places_of(scene, path, point, tolerance))
          places.push_back(s);
  return places;
}

} // namespace frictionbeam
