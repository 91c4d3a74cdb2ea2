// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/pipes/patch_edges.h"

#include "mesh/pipe_path.h"
#include "scene/support_pair.h"

#include <algorithm>

namespace frictionbeam::accuracy {

namespace {

/// A place of a support, and how its pipe goes there.
struct PatchPlace {
  const SupportInfo *info;
  Vector3 tangent;     ///< unit
  bool has_both_edges; ///< on the same straight run
};

class PatchEdges {
public:
  PatchEdges(Scene &scene, const Results &results) : scene(scene), results(results) {
    for (const Pipe &pipe : scene.pipes)
      paths.emplace_back(pipe, scene.units);
  }

  void add(const WallAtSupport &wall) {
    const FrictionSupport &support = scene.supports[wall.support];
    const double width = support.width > 0. ? support.width : 2. * wall.radius;
    const std::vector<PatchPlace> places = patches_of(support, width);
    if (is_of_a_pair(support.kind) ||
        !std::all_of(places.begin(), places.end(),
                     [](const PatchPlace &place) { return place.has_both_edges; }))
      for (const PatchPlace &place : places)
        add_spring(wall, place, width);
    else
      stand_on_edges(wall.support, places, width);
  }

private:
  std::vector<PatchPlace> patches_of(const FrictionSupport &support, const double width) const {
    std::vector<PatchPlace> places;
    for (const SupportInfo *const info : places_of(support, results))
      if (const auto place = on_pipe(*info, width))
        places.push_back(*place);
    return places;
  }

  std::optional<PatchPlace> on_pipe(const SupportInfo &info, const double width) const {
    for (unsigned int p = 0; p < paths.size(); ++p) {
      const double tolerance = 1e-3 * scene.sections[scene.pipes[p].section].outer_radius;
      for (const PipePath::Segment &segment : paths[p].segments())
        if (const auto s = segment.place(info.position, tolerance)) {
          const Vector3 tangent = segment.tangent(*s - segment.start);
          const auto goes_straight = [&](const double way) {
            return *s + way >= 0. && *s + way <= paths[p].length() &&
                   paths[p].point(*s + way).distance(info.position + way * tangent) < tolerance;
          };
          return PatchPlace{&info, tangent,
                            goes_straight(width / 2.) && goes_straight(-width / 2.)};
        }
    }
    return {};
  }

  /// Beside the wall's stiffness k over a width w, k w^2/12, what holds the rotation is as much as
  /// that times 4.5 (r/t = 17; measured, doc/solid.md): what one edge is pressed and the other
  /// relieved by, bends the wall nearby only.
  void add_spring(const WallAtSupport &wall, const PatchPlace &place, const double width) {
    constexpr double of_edges = 4.5;
    const Vector3 axis = dealii::cross_product_3d(place.tangent, place.info->normal);
    Spring spring;
    spring.name = spring.point = "edges of " + place.info->name;
    spring.stiffness[3] = of_edges * wall.stiffness * width * width / 12.;
    spring.directions[3] = {{0., 0., 0., axis[0], axis[1], axis[2]}};
    scene.add_point(spring.point, place.info->position);
    scene.springs.push_back(spring);
  }

  void stand_on_edges(const unsigned int number, const std::vector<PatchPlace> &places,
                      const double width) {
    const std::string name = scene.supports[number].name;
    FrictionSupport half = scene.supports[number];
    half.kind = "stop"; // of which two halves are one support
    half.share /= 2.;
    for (const auto &[side, sign] : {std::pair(plus_half, 1.), std::pair(minus_half, -1.)}) {
      half.name = name + side;
      half.placement = {};
      for (const PatchPlace &place : places) {
        half.placement.points.push_back("edge of " + place.info->name + side);
        scene.add_point(half.placement.points.back(),
                        place.info->position + sign * width / 2. * place.tangent);
      }
      if (sign > 0.)
        scene.supports[number] = half;
      else
        scene.supports.push_back(half);
    }
    for (const PatchPlace &place : places)
      ask_both(*place.info);
  }

  /// What is asked of the support, or of the point where it stands, of both edges.
  void ask_both(const SupportInfo &info) {
    for (Quantity &quantity : scene.quantities) {
      const bool is_holder = quantity.is(QuantityKind::Of::holder) ||
                             (quantity.unit_is_force() && !quantity.has_pipe());
      const auto point = scene.places.find(quantity.where);
      if (is_holder && point != scene.places.end() && point->second == info.position)
        quantity.where = info.name;
      if (quantity.where == info.name &&
          (quantity.what == "gap" || quantity.what == "slip1" || quantity.what == "slip2"))
        quantity.scale /= 2.; // the mean
    }
  }

  Scene &scene;
  const Results &results;
  std::vector<PipePath> paths;
};

} // namespace

Scene with_edges(Scene scene, const WallsAtSupports &walls, const Results &results) {
  PatchEdges edges(scene, results);
  for (const WallAtSupport &wall : walls.walls)
    edges.add(wall);
  return scene;
}

} // namespace frictionbeam::accuracy
