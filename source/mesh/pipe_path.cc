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

PipePath::PipePath(const Pipe &pipe, const UnitSystem &units) {
  const auto &route = pipe.route;
  const auto where = [&](const unsigned int i) {
    return "point " +
           (route[i].name.empty() ? "number " + std::to_string(i + 1) : "'" + route[i].name + "'") +
           " of the route of pipe '" + pipe.name + "'";
  };

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
      throw UserError("The " + where(i) +
                      " lies where the run before it begins, so the run has no "
                      "length. Remove one of the two points or give a smaller bend radius.");
    const Vector3 t = leg / leg.norm();
    double cut = 0.; // of the leg, by the bend at its end
    Vector3 next;
    double angle = 0.;
    if (route[i].bend_radius > 0. && i + 1 < route.size()) {
      next = route[i + 1].position - route[i].position;
      if (next.norm() == 0.)
        throw UserError("The " + where(i + 1) + " lies on the point before it.");
      next /= next.norm();
      angle = std::acos(std::clamp(t * next, -1., 1.));
      if (angle > numbers::PI - 1e-6)
        throw UserError("The route turns back on itself at " + where(i) +
                        ": a bend needs an angle below 180 degrees. Use two corners.");
      cut = route[i].bend_radius * std::tan(angle / 2.);
      const double next_length = (route[i + 1].position - route[i].position).norm();
      if (cut > leg.norm() * (1. + same_place) || cut > next_length * (1. + same_place)) {
        const auto length = [&](const double value) { return in_units(units, value, "m"); };
        throw UserError("The bend of radius " + length(route[i].bend_radius) + " at " + where(i) +
                        " takes " + length(cut) + " of each leg, and what is left of the legs is " +
                        length(leg.norm()) + " and " + length(next_length) +
                        ". Give a smaller radius or longer legs.");
      }
    }
    if (leg.norm() - cut > same_place * leg.norm()) {
      Segment straight;
      straight.length = leg.norm() - cut;
      straight.begin = begin;
      straight.end = begin + straight.length * t;
      straight.first_tangent = t;
      append(straight);
    }
    begin = route[i].position;
    if (angle > 1e-9) {
      Segment bend;
      bend.radius = route[i].bend_radius;
      bend.length = bend.radius * angle;
      bend.begin = route[i].position - cut * t;
      bend.end = begin = route[i].position + cut * next;
      bend.first_tangent = t;
      bend.inward = next - (next * t) * t;
      bend.inward /= bend.inward.norm();
      bend.centre = bend.begin + bend.radius * bend.inward;
      append(bend);
    }
    if (angle <= 1e-9)
      places.push_back({route[i].name, total_length});
    else if (!route[i].name.empty())
      places.push_back({route[i].name, total_length - parts.back().length / 2.});
  }
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
  for (const Segment &part : parts) {
    double s = (position - part.begin) * part.first_tangent;
    if (part.radius > 0.) {
      const Vector3 arm = position - part.centre;
      s = part.radius * std::atan2(arm * part.first_tangent, -(arm * part.inward));
    }
    s = std::clamp(s, 0., part.length);
    if (part.point(s).distance(position) > tolerance)
      continue;
    if (result.empty() || part.start + s > result.back() + 2. * tolerance)
      result.push_back(part.start + s);
  }
  return result;
}

} // namespace frictionbeam
