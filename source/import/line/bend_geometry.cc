// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/bend_geometry.h"

#include "base/number_text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::import {

namespace {

constexpr double degree = 3.14159265358979323846 / 180.;
constexpr double least_turn = 0.5 * degree, largest_turn = 179. * degree;
constexpr double largest_kink = 2. * degree; ///< that passes for rounding
constexpr double differing_radius = 0.01;    ///< of a radius or angle that is said twice
constexpr double cells_to_tell = 20.; ///< tolerances that a pipe must be long to have a direction

double angle_between(const Vector3 &a, const Vector3 &b) {
  return std::acos(std::max(-1., std::min(1., a * b / (a.norm() * b.norm()))));
}

std::string in_mm(const double length) { return rounded_number(1e3 * length, 6) + " mm"; }
std::string in_degrees(const double angle) { return rounded_number(angle / degree) + " degrees"; }

/// A radius as short as it can be written without a tangent longer than @p tangent.
double written_radius(const double tangent, const double turn) {
  const double half = std::tan(turn / 2.), radius = tangent / half;
  const double rounded = std::round(radius * 1e7) / 1e7;
  return rounded * half <= tangent * (1. + 5e-10) ? rounded : std::floor(radius * 1e9) / 1e9;
}

} // namespace

std::string text_of_place(const Point3 &point) {
  return "(" + exact_number(point[0]) + ", " + exact_number(point[1]) + ", " +
         exact_number(point[2]) + ") m";
}

bool is_off_line(const Point3 &point, const Point3 &a, const Point3 &b, const double tolerance) {
  const Vector3 way = b - a, to = point - a;
  const double length = way.norm();
  return length == 0. ? to.norm() > tolerance
                      : (to - (to * way / (length * length)) * way).norm() > tolerance;
}

void give_bend(const PcfFile &file, const PcfComponent &component, const Point3 &a, const Point3 &b,
               const double tolerance, Piece &piece, Notes &notes) {
  const Point3 &centre = component.centre->position;
  const double first = centre.distance(a), second = centre.distance(b);
  const auto refuse = [&](const std::string &read) {
    file.fail(component.line, component.keyword + " " + read,
              "CENTRE-POINT where the tangents at both END-POINTs meet, equally far from both",
              "the right CENTRE-POINT; of a bend of 180 degrees with ANGLE 18000");
  };
  if (std::abs(first - second) > std::max(tolerance, 1e-3 * first) ||
      std::min(first, second) <= tolerance)
    refuse("whose CENTRE-POINT " + text_of_place(centre) + " is " + in_mm(first) +
           " from one END-POINT and " + in_mm(second) + " from the other");
  const Vector3 chord = (b - a) / (b - a).norm();
  const Point3 middle(a + 0.5 * (b - a));
  const Point3 corner = on_grid(Point3(centre - ((centre - middle) * chord) * chord));
  const double turn = angle_between(corner - a, b - corner);
  if (turn < least_turn || turn > largest_turn)
    refuse("that turns by " + in_degrees(turn));
  give_corner(piece, a, corner, b);
  if (component.bend_radius && *component.bend_radius > 0. &&
      std::abs(*component.bend_radius - piece.radius) > differing_radius * piece.radius)
    notes.assumed.push_back({component.line, component.keyword + ": BEND-RADIUS is " +
                                                 in_mm(*component.bend_radius) +
                                                 ", its points make a radius of " +
                                                 in_mm(piece.radius) + ", which is taken"});
  if (component.angle && std::abs(*component.angle - turn) > differing_radius * turn)
    notes.assumed.push_back(
        {component.line, component.keyword + ": ANGLE is " + in_degrees(*component.angle) +
                             ", its points turn by " + in_degrees(turn) + ", which is taken"});
}

void give_corner(Piece &piece, const Point3 &a, const Point3 &corner, const Point3 &b) {
  piece.corner = on_grid(corner);
  piece.radius = written_radius(std::min(corner.distance(a), corner.distance(b)),
                                angle_between(corner - a, b - corner));
}

std::pair<Piece, Piece> cut_bend(const Piece &bend, const Point3 &a, const Point3 &place,
                                 const Point3 &b) {
  const auto part = [&](const Point3 &end) {
    const double turn = 2. * std::asin(std::min(1., place.distance(end) / (2. * bend.radius)));
    const Vector3 way = *bend.corner - end;
    Piece piece = bend;
    give_corner(piece, end, Point3(end + bend.radius * std::tan(turn / 2.) / way.norm() * way),
                place);
    return piece;
  };
  return {part(a), part(b)};
}

namespace {

/// The part of @p way that is square to the line of both ends.
Vector3 across(const PcfComponent &component, const Vector3 &way) {
  const Vector3 chord = component.ends[1].position - component.ends[0].position;
  return way - (way * chord / chord.norm_square()) * chord;
}

/// The way in which something comes in square to the line of both ends; empty if nothing does.
std::optional<Vector3> square_way_in(const PcfLine &line, const PcfComponent &component,
                                     const double tolerance) {
  const Point3 &a = component.ends[0].position, &b = component.ends[1].position;
  for (const PcfComponent &other : line.components) {
    if (&other == &component || other.ends.size() != 2)
      continue;
    for (const unsigned int end : {0u, 1u}) {
      const Point3 &here = other.ends[end].position;
      if (std::min(here.distance(a), here.distance(b)) > tolerance)
        continue;
      const Vector3 along = here - (other.centre ? *other.centre : other.ends[1 - end]).position,
                    square = across(component, along);
      if (along.norm() > cells_to_tell * tolerance &&
          square.norm() > std::cos(largest_kink) * along.norm())
        return square;
    }
  }
  return {};
}

Point3 middle_of(const PcfComponent &component) {
  return Point3(component.ends[0].position +
                0.5 * (component.ends[1].position - component.ends[0].position));
}

/// Whether CENTRE-POINT is in the middle between the ends.
bool is_centre_of_arc(const PcfComponent &component, const double tolerance) {
  return component.centre->position.distance(middle_of(component)) <=
         std::max(tolerance,
                  1e-3 * component.ends[0].position.distance(component.ends[1].position));
}

} // namespace

bool turns_back(const PcfLine &line, const PcfComponent &component, const double tolerance) {
  return is_centre_of_arc(component, tolerance) ||
         (component.angle && std::abs(*component.angle - 180. * degree) < differing_radius &&
          square_way_in(line, component, tolerance));
}

Point3 top_of_return(const PcfFile &file, const PcfLine &line, const PcfComponent &component,
                     const double tolerance) {
  const Point3 middle = middle_of(component);
  const std::optional<Vector3> way = square_way_in(line, component, tolerance);
  if (!way)
    file.fail(component.line,
              component.keyword + " whose CENTRE-POINT " +
                  text_of_place(component.centre->position) +
                  " is in the middle between its ends, and no pipe comes in square to them",
              "a bend of 180 degrees with pipe square at one of its ends",
              "two bends of 90 degrees, or CENTRE-POINT where the tangents meet");
  const double radius = component.ends[0].position.distance(component.ends[1].position) / 2.;
  return on_grid(Point3(middle + radius / way->norm() * *way));
}

void check_tangents(const PcfFile &file, const PcfLine &line, const Network &network,
                    const double tolerance, Notes &notes) {
  const auto pieces_at = network.pieces_at();
  for (std::size_t i = 0; i < network.pieces.size(); ++i) {
    const Piece &bend = network.pieces[i];
    for (const unsigned int end : {bend.from, bend.to}) {
      if (bend.radius == 0. || pieces_at[end].size() != 2)
        continue;
      const Piece &other =
          network.pieces[pieces_at[end][0] == i ? pieces_at[end][1] : pieces_at[end][0]];
      const Point3 &here = network.nodes[end],
                   &there = network.nodes[other.from == end ? other.to : other.from];
      if (other.corner || here.distance(there) < cells_to_tell * tolerance)
        continue;
      const double kink = angle_between(here - there, *bend.corner - here);
      if (kink <= largest_kink)
        continue;
      const PcfComponent &component = line.components[bend.component];
      if (std::abs(kink - 90. * degree) <= largest_kink) {
        const Point3 mirrored(network.nodes[bend.from] + (network.nodes[bend.to] - *bend.corner));
        file.fail(component.line,
                  component.keyword + " whose CENTRE-POINT " + text_of_place(*bend.corner) +
                      " stands across the pipe of line " +
                      std::to_string(line.components[other.component].line) +
                      " that comes in: it is the centre of the arc",
                  "CENTRE-POINT where the tangents at both END-POINTs meet",
                  "of a bend of 90 degrees: CENTRE-POINT " + text_of_place(mirrored));
      }
      notes.assumed.push_back(
          {component.line, component.keyword + " and " + line.components[other.component].text() +
                               " meet with a kink of " + in_degrees(kink) + ", which is kept"});
    }
  }
}

} // namespace frictionbeam::import
