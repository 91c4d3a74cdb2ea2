// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/solid/solid_stretches.h"

#include "base/number_text.h"
#include "base/user_error.h"
#include "mesh/places_on_pipe.h"
#include "scene/file/parameter_reader.h"
#include "scene/in_units.h"
#include "scene/solid/mixed_entries.h"
#include "scene/solid/wall_refusal.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace frictionbeam {

namespace {

constexpr double same = 1e-3; ///< of the outer radius: two places along a pipe are one
std::set<std::string> names_of(const Scene &scene) {
  const std::vector<std::string> names = solid_places(scene);
  return {names.begin(), names.end()};
}

class StretchLayout {
public:
  StretchLayout(const Scene &scene, const std::vector<PipePath> &paths)
      : scene(scene), paths(paths), asked(names_of(scene)) {}

  std::vector<SolidStretch> all();
  std::vector<SolidStretch> rooms();

private:
  using Segment = PipePath::Segment;

  void add_bends(const unsigned int pipe);
  void add_points(const unsigned int pipe);
  /// From where a bend or anchor or the pipe's beginning is before a stretch to one behind it.
  std::array<double, 2> room_of(const SolidStretch &stretch) const;
  /// A place along a pipe, or that of a point of the scene that is as good as there.
  double nearest_point(const unsigned int pipe, const double s) const;
  /// Take straight pipe on either side, as far as there is.
  void extend(SolidStretch &stretch) const;
  /// One stretch for those that meet.
  void join(std::vector<SolidStretch> &stretches) const;
  /// Places of the anchors of a pipe along it.
  std::vector<double> anchors(const unsigned int pipe) const {
    return places_of_anchors(scene, paths[pipe], same * outer(pipe));
  }
  bool is_anchor(const unsigned int pipe, const double s) const {
    const std::vector<double> held = anchors(pipe);
    return std::any_of(held.begin(), held.end(),
                       [&](const double at) { return std::abs(at - s) <= same * outer(pipe); });
  }
  std::vector<double> places(const unsigned int pipe, const std::string &point) const {
    return places_of(scene, paths[pipe], point, same * outer(pipe));
  }
  double outer(const unsigned int pipe) const {
    return scene.sections[scene.pipes[pipe].section].outer_radius;
  }
  std::string place_in_words(const unsigned int pipe, const double s) const {
    return scene.pipes[pipe].name + "_at_" +
           to_text(std::round(s / scene.units.factor("m") * 1e3) / 1e3);
  }
  /// Those of routes and Points.
  std::vector<std::string> names_on_pipes() const;
  void check_found() const;
  /// @throws UserError for a pipe whose wall cannot be a solid
  void check_pipe(const Pipe &pipe, const double bend_radius) const;

  const Scene &scene;
  const std::vector<PipePath> &paths;
  const std::set<std::string> asked;
  std::set<std::string> found;
  std::vector<SolidStretch> stretches;
};

void StretchLayout::add_bends(const unsigned int pipe) {
  for (const Segment &segment : paths[pipe].segments()) {
    if (segment.radius == 0.)
      continue;
    SolidStretch stretch;
    stretch.pipe = pipe;
    stretch.from = segment.start;
    stretch.to = segment.start + segment.length;
    stretch.name = place_in_words(pipe, segment.start + segment.length / 2.);
    for (const PipePath::RoutePlace &place : paths[pipe].route_points())
      if (place.s > stretch.from && place.s < stretch.to && !place.name.empty())
        stretch.name = place.name;
    bool is_asked = asked.empty() || asked.count(all_bends) > 0;
    for (const std::string &point : asked) {
      const std::vector<double> at = places(pipe, point);
      if (point == stretch.name || std::any_of(at.begin(), at.end(), [&](const double s) {
            return s > stretch.from && s < stretch.to;
          })) {
        found.insert(point);
        is_asked = true;
      }
    }
    if (is_asked)
      stretches.push_back(stretch);
  }
}

void StretchLayout::add_points(const unsigned int pipe) {
  for (const std::string &point : asked)
    for (const double s : found.count(point) == 0 ? places(pipe, point) : std::vector<double>()) {
      found.insert(point);
      SolidStretch stretch;
      stretch.pipe = pipe;
      stretch.from = stretch.to = s;
      stretch.name = point;
      if (is_anchor(pipe, s)) { // a part on each side that has pipe
        const bool has_pipe_before = s > same * outer(pipe),
                   has_pipe_behind = s < paths[pipe].length() - same * outer(pipe);
        if (has_pipe_before) {
          stretch.anchored = {{false, true}};
          stretches.push_back(stretch);
          stretch.name += "_behind";
        }
        stretch.anchored = {{true, false}};
        if (!has_pipe_behind)
          continue;
      }
      stretches.push_back(stretch);
    }
}

std::array<double, 2> StretchLayout::room_of(const SolidStretch &stretch) const {
  const double tolerance = same * outer(stretch.pipe);
  double low = 0., high = paths[stretch.pipe].length();
  for (const Segment &segment : paths[stretch.pipe].segments())
    if (segment.radius > 0.) {
      if (segment.start + segment.length <= stretch.from + tolerance)
        low = std::max(low, segment.start + segment.length);
      if (segment.start >= stretch.to - tolerance)
        high = std::min(high, segment.start);
    }
  for (const double s : anchors(stretch.pipe)) {
    if (s <= stretch.from + tolerance && !(stretch.anchored[1] && s >= stretch.to - tolerance))
      low = std::max(low, s);
    if (s >= stretch.to - tolerance && !(stretch.anchored[0] && s <= stretch.from + tolerance))
      high = std::min(high, s);
  }
  return {{low, high}};
}

void StretchLayout::extend(SolidStretch &stretch) const {
  const auto [low, high] = room_of(stretch);
  const double tangent = scene.solid.reach *
                         scene.sections[scene.pipes[stretch.pipe].section].decay_length(),
               tolerance = same * outer(stretch.pipe);
  // No sliver of a pipe beside it.
  const double from = stretch.from - tangent, to = stretch.to + tangent;
  stretch.is_short = from < low - tolerance || to > high + tolerance;
  stretch.from = from < low + outer(stretch.pipe) / 2. ? low : nearest_point(stretch.pipe, from);
  stretch.to = to > high - outer(stretch.pipe) / 2. ? high : nearest_point(stretch.pipe, to);
}

double StretchLayout::nearest_point(const unsigned int pipe, const double s) const {
  std::vector<double> named;
  for (const PipePath::RoutePlace &place : paths[pipe].route_points())
    named.push_back(place.s);
  for (const NamedPoint &point : scene.points)
    for (const double at : paths[pipe].all_places(point.position, same * outer(pipe)))
      named.push_back(at);
  double result = s, nearest = outer(pipe) / 10.; // shorter layers of cells are not worth it
  for (const double at : named)
    if (std::abs(at - s) < nearest) {
      nearest = std::abs(at - s);
      result = at;
    }
  return result;
}

void StretchLayout::join(std::vector<SolidStretch> &all) const {
  std::stable_sort(all.begin(), all.end(), [](const SolidStretch &a, const SolidStretch &b) {
    return a.pipe != b.pipe ? a.pipe < b.pipe : a.from < b.from;
  });
  std::vector<SolidStretch> joined;
  for (const SolidStretch &stretch : all) {
    const double tolerance = same * outer(stretch.pipe);
    if (!joined.empty() && joined.back().pipe == stretch.pipe &&
        stretch.from <= joined.back().to + tolerance && !is_anchor(stretch.pipe, stretch.from)) {
      joined.back().to = std::max(joined.back().to, stretch.to);
      joined.back().name += "_" + stretch.name;
      joined.back().is_short = joined.back().is_short || stretch.is_short;
    } else
      joined.push_back(stretch);
    joined.back().anchored = {is_anchor(stretch.pipe, joined.back().from),
                              is_anchor(stretch.pipe, joined.back().to)};
  }
  all = joined;
}

std::vector<std::string> StretchLayout::names_on_pipes() const {
  std::vector<std::string> names;
  for (const PipePath &path : paths)
    for (const PipePath::RoutePlace &place : path.route_points())
      if (!place.name.empty())
        names.push_back(place.name);
  for (const NamedPoint &point : scene.points)
    for (unsigned int pipe = 0; pipe < paths.size(); ++pipe)
      if (!places(pipe, point.name).empty()) {
        names.push_back(point.name);
        break;
      }
  return names;
}

void StretchLayout::check_found() const {
  for (const std::string &point : asked)
    if (found.count(point) == 0 && point != all_bends)
      throw UserError("Solid/At names a point that is on no pipe.\n  read:    '" + point +
                      "'\n  allowed: points of routes, corners of bends among them, and Points on "
                      "pipes, or all bends: " +
                      first_of(names_on_pipes()) + "\n  try:     all bends");
}

void StretchLayout::check_pipe(const Pipe &pipe, const double bend_radius) const {
  if (const auto refusal = wall_refusal(scene, pipe, bend_radius))
    throw UserError(
        "Pipe " + pipe.name + ": its wall cannot be a solid.\n  read:    " + refusal->read +
        "\n  allowed: " + refusal->allowed + " with Solid/At\n  try:     " + refusal->hint +
        ", or Solid/At with the names of other bends alone");
}

std::vector<SolidStretch> StretchLayout::rooms() {
  for (unsigned int p = 0; p < paths.size(); ++p)
    add_bends(p);
  for (SolidStretch &bend : stretches) {
    const std::array<double, 2> room = room_of(bend);
    bend.from = room[0];
    bend.to = room[1];
  }
  return stretches;
}

std::vector<SolidStretch> StretchLayout::all() {
  for (unsigned int p = 0; p < paths.size(); ++p)
    add_bends(p);
  for (unsigned int p = 0; p < paths.size(); ++p)
    add_points(p);
  check_found();
  if (stretches.empty())
    throw UserError(
        "No pipe of the line is solid.\n  read:    all bends in Solid/At, of pipes without "
        "a bend\n  allowed: pipes with bends, or names of points\n  try:     to leave At "
        "out");
  for (const SolidStretch &stretch : stretches)
    for (const Segment &segment : paths[stretch.pipe].segments())
      if (segment.start <= stretch.to && segment.start + segment.length >= stretch.from)
        check_pipe(scene.pipes[stretch.pipe], segment.radius);
  for (SolidStretch &stretch : stretches)
    extend(stretch);
  join(stretches);
  return stretches;
}

} // namespace

std::vector<SolidStretch> rooms_of_bends(const Scene &scene, const std::vector<PipePath> &paths) {
  return StretchLayout(scene, paths).rooms();
}

std::vector<SolidStretch> solid_stretches(const Scene &scene, const std::vector<PipePath> &paths) {
  return StretchLayout(scene, paths).all();
}

} // namespace frictionbeam
