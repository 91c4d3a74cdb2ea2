// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/pipe_path.h"
#include "base/numbers.h"
#include "base/user_error.h"
#include "scene/in_units.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

Point3 PipePath::Segment::point(const double s) const {
  if (radius == 0.)
    return begin + s * first_tangent;
  const double angle = s / radius;
  return centre + radius * (std::sin(angle) * first_tangent - std::cos(angle) * inward);
}

Vector3 PipePath::Segment::tangent(const double s) const {
  if (radius == 0.)
    return first_tangent;
  const double angle = s / radius;
  return std::cos(angle) * first_tangent + std::sin(angle) * inward;
}

std::optional<double> PipePath::Segment::place(const Point3 &position,
                                               const double tolerance) const {
  double s = (position - begin) * first_tangent;
  if (radius > 0.) {
    const Vector3 arm = position - centre;
    s = radius * std::atan2(arm * first_tangent, -(arm * inward));
  }
  s = std::clamp(s, 0., length);
  if (point(s).distance(position) > tolerance)
    return {};
  return start + s;
}

namespace {

constexpr double no_angle = 1e-9; ///< of a corner that is none [rad]

/// Point @p i of a pipe's route, for messages.
std::string where(const Pipe &pipe, const unsigned int i) {
  const RoutePoint &point = pipe.route[i];
  return "point " +
         (point.name.empty() ? "number " + std::to_string(i + 1) : "'" + point.name + "'") +
         " of the route of pipe '" + pipe.name + "'";
}

/// The corner at point @p i, which has a bend: its tangents are R tan(angle/2) long.
/// @param leg that leads there @param units of messages
PipePath::Corner corner_at(const Pipe &pipe, const unsigned int i, const Vector3 &leg,
                           const UnitSystem &units) {
  const double radius = pipe.route[i].bend_radius, length = leg.norm();
  PipePath::Corner corner;
  corner.next = pipe.route[i + 1].position - pipe.route[i].position;
  const double next_length = corner.next.norm();
  if (next_length == 0.)
    throw UserError("The " + where(pipe, i + 1) + " lies on the point before it.");
  corner.next /= next_length;
  corner.angle = std::acos(std::clamp(leg / length * corner.next, -1., 1.));
  if (corner.angle > numbers::PI - 1e-6)
    throw UserError("The route turns back on itself at " + where(pipe, i) +
                    ": a bend needs an angle below 180 degrees. Use two corners.");
  corner.cut = radius * std::tan(corner.angle / 2.);
  if (corner.cut > length * (1. + same_place) || corner.cut > next_length * (1. + same_place)) {
    const auto text = [&](const double value) { return in_units(units, value, "m"); };
    throw UserError("The bend of radius " + text(radius) + " at " + where(pipe, i) + " takes " +
                    text(corner.cut) + " of each leg, and what is left of the legs is " +
                    text(length) + " and " + text(next_length) +
                    ". Give a smaller radius or longer legs.");
  }
  return corner;
}

} // namespace

PipePath::PipePath(const Pipe &pipe, const UnitSystem &units) {
  const auto &route = pipe.route;
  Point3 begin = route.front().position;
  places.push_back({route.front().name, 0.});
  for (unsigned int i = 1; i < route.size(); ++i) {
    const Vector3 leg = route[i].position - begin;
    if (leg.norm() <= same_place * total_length && !parts.empty() && parts.back().radius > 0. &&
        route[i].bend_radius == 0.) { // the end of the bend before, by its name
      places.push_back({route[i].name, total_length});
      continue;
    }
    if (leg.norm() == 0.)
      throw UserError("The " + where(pipe, i) +
                      " lies where the run before it begins, so the run has no "
                      "length. Remove one of the two points or give a smaller bend radius.");
    const Vector3 tangent = leg / leg.norm();
    Corner corner;
    if (route[i].bend_radius > 0. && i + 1 < route.size())
      corner = corner_at(pipe, i, leg, units);
    if (leg.norm() - corner.cut > same_place * leg.norm())
      append_run(begin, tangent, leg.norm() - corner.cut);
    if (corner.angle > no_angle) {
      append_bend(corner, route[i], tangent);
      begin = parts.back().end;
      if (!route[i].name.empty())
        places.push_back({route[i].name, total_length - parts.back().length / 2.});
    } else {
      begin = route[i].position;
      places.push_back({route[i].name, total_length});
    }
  }
}

PipePath::PipePath(std::vector<Segment> segments, std::vector<RoutePlace> route_points)
    : parts(std::move(segments)), places(std::move(route_points)),
      total_length(parts.back().start + parts.back().length) {}

void PipePath::append_run(const Point3 &begin, const Vector3 &tangent, const double length) {
  Segment straight;
  straight.length = length;
  straight.begin = begin;
  straight.end = begin + length * tangent;
  straight.first_tangent = tangent;
  append(straight);
}

void PipePath::append_bend(const Corner &corner, const RoutePoint &at, const Vector3 &tangent) {
  Segment bend;
  bend.radius = at.bend_radius;
  bend.length = bend.radius * corner.angle;
  bend.begin = at.position - corner.cut * tangent;
  bend.end = at.position + corner.cut * corner.next;
  bend.first_tangent = tangent;
  bend.inward = corner.next - (corner.next * tangent) * tangent;
  bend.inward /= bend.inward.norm();
  bend.centre = bend.begin + bend.radius * bend.inward;
  append(bend);
}

void PipePath::append(Segment segment) {
  segment.start = total_length;
  total_length += segment.length;
  parts.push_back(segment);
}

const PipePath::Segment &PipePath::segment_at(const double s) const {
  const auto after =
      std::upper_bound(parts.begin(), parts.end(), s,
                       [](const double value, const Segment &part) { return value < part.start; });
  return after == parts.begin() ? parts.front() : *(after - 1);
}

Point3 PipePath::point(const double s) const {
  const Segment &part = segment_at(s);
  return part.point(s - part.start);
}

std::vector<double> PipePath::all_places(const Point3 &position, const double tolerance) const {
  std::vector<double> result;
  for (const Segment &part : parts)
    if (const auto s = part.place(position, tolerance))
      if (result.empty() || *s > result.back() + 2. * tolerance)
        result.push_back(*s);
  return result;
}

std::vector<PipePath> paths_of(const Scene &scene) {
  std::vector<PipePath> paths;
  for (const Pipe &pipe : scene.pipes)
    paths.emplace_back(pipe, scene.units);
  return paths;
}

} // namespace frictionbeam
