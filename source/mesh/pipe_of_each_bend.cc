// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/pipe_of_each_bend.h"

#include "mesh/places_on_pipe.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

using Segment = PipePath::Segment;

/// Where a pipe is cut: in the middle of the first straight run behind each bend but the last, or
/// at its end, if there is none.
std::vector<double> cuts_of(const PipePath &path) {
  std::vector<double> cuts;
  const std::vector<Segment> &parts = path.segments();
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const bool goes_on = std::any_of(parts.begin() + i + 1, parts.end(),
                                     [](const Segment &one) { return one.radius > 0.; });
    if (parts[i].radius > 0. && goes_on)
      cuts.push_back(parts[i + 1].start +
                     (parts[i + 1].radius > 0. ? 0. : parts[i + 1].length / 2.));
  }
  return cuts;
}

/// Where a point of the route is along the path, behind another one; of a bend's corner, the middle
/// of the bend.
double place_of(const PipePath &path, const RoutePoint &point, const double after,
                const double tolerance) {
  for (const Segment &bend : path.segments()) {
    if (bend.radius == 0. || bend.radius != point.bend_radius)
      continue;
    const double cut = bend.radius * std::tan(bend.length / bend.radius / 2.);
    if ((bend.begin + cut * bend.first_tangent).distance(point.position) <= tolerance &&
        bend.start + bend.length / 2. >= after - tolerance)
      return bend.start + bend.length / 2.;
  }
  for (const double s : path.all_places(point.position, tolerance))
    if (s >= after - tolerance)
      return s;
  return after;
}

/// Whether a pipe is named by what a cut would change.
bool must_be_whole(const Scene &scene, const Pipe &pipe) {
  const auto names = [&](const auto &parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const auto &part) { return part.pipe == pipe.name; });
  };
  const auto is_bed = [&](const auto &parts) {
    return std::any_of(parts.begin(), parts.end(), [&](const auto &part) {
      return part.placement.continuous && part.placement.pipe == pipe.name;
    });
  };
  return pipe.route.empty() || pipe.end_section || pipe.total_mass || names(scene.joints) ||
         names(scene.quantities) || !scene.tees.empty() || !scene.initial.empty() ||
         is_bed(scene.supports) || is_bed(scene.restraints);
}

class Cutter {
public:
  Cutter(Scene scene, std::vector<unsigned int> &owner)
      : before(scene), scene(std::move(scene)), owner(owner) {}

  Scene all() {
    scene.pipes.clear();
    owner.clear();
    for (unsigned int p = 0; p < before.pipes.size(); ++p)
      cut(p);
    return scene;
  }

private:
  void cut(const unsigned int p);
  /// Supports of a placement along the pipe stand at points of the same places.
  void place_at_points(const std::string &part, const Pipe &pipe, const PipePath &path,
                       Placement &placement);

  const Scene before;
  Scene scene;
  std::vector<unsigned int> &owner;
};

void Cutter::place_at_points(const std::string &part, const Pipe &pipe, const PipePath &path,
                             Placement &placement) {
  if (placement.pipe != pipe.name || placement.every <= 0.)
    return;
  const double tolerance = 1e-3 * before.sections[pipe.section].outer_radius;
  const auto place = [&](const std::string &point, const double otherwise) {
    const std::vector<double> found = places_of(before, path, point, tolerance);
    return found.empty() ? otherwise : found.front();
  };
  const double from = place(placement.from, 0.), to = place(placement.to, path.length());
  const double every = placement.every;
  placement = {};
  for (unsigned int i = 1; from + i * every < to - tolerance; ++i) {
    placement.points.push_back("place " + std::to_string(i) + " of " + part);
    if (scene.places.count(placement.points.back()) == 0)
      scene.add_point(placement.points.back(), path.point(from + i * every));
  }
}

void Cutter::cut(const unsigned int p) {
  const Pipe &pipe = before.pipes[p];
  const PipePath path(pipe, before.units);
  const std::vector<double> cuts =
      must_be_whole(before, pipe) ? std::vector<double>() : cuts_of(path);
  Pipe piece = pipe;
  piece.route.clear();
  std::size_t next = 0; // point of the route
  const double tolerance = 1e-3 * before.sections[pipe.section].outer_radius;
  double reached = 0.;
  for (std::size_t c = 0; c <= cuts.size(); ++c) {
    // Corners of bends before the cut, and other points before it.
    for (; next < pipe.route.size(); ++next) {
      const double s = place_of(path, pipe.route[next], reached, tolerance);
      if (c < cuts.size() && s > cuts[c])
        break;
      reached = s;
      piece.route.push_back(pipe.route[next]);
    }
    if (c < cuts.size())
      piece.route.push_back({"", path.point(cuts[c]), 0.});
    scene.pipes.push_back(piece);
    owner.push_back(p);
    const RoutePoint last = piece.route.back();
    piece.route = {last};
    piece.name = pipe.name + " after " + std::to_string(c + 1) + " bends";
    if (c < cuts.size())
      for (Load &load : scene.loads)
        if (!load.pipes.empty() && load.is_on(pipe.name))
          load.pipes.push_back(piece.name);
  }
  if (cuts.empty())
    return;
  for (FrictionSupport &support : scene.supports)
    place_at_points(support.name, pipe, path, support.placement);
  for (Restraint &restraint : scene.restraints)
    place_at_points(restraint.name, pipe, path, restraint.placement);
}

} // namespace

Scene with_pipe_of_each_bend(Scene scene, std::vector<unsigned int> &owner) {
  return Cutter(std::move(scene), owner).all();
}

} // namespace frictionbeam
