// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/place_on_pieces.h"

#include <cmath>

namespace frictionbeam::import {

std::optional<PlaceOnPieces::Place> PlaceOnPieces::nearest(const Point3 &point) const {
  std::optional<Place> best;
  for (std::size_t i = 0; i < network.pieces.size(); ++i) {
    const Place place = on(i, point);
    if (!best || place.distance < best->distance)
      best = place;
  }
  return best;
}

double PlaceOnPieces::reach(const std::size_t piece, const SectionPlanner &sections) const {
  return sections.outer_diameter(network.pieces[piece].section);
}

PlaceOnPieces::Place PlaceOnPieces::on_piece(const std::size_t piece, const Point3 &point) const {
  const Piece &one = network.pieces[piece];
  const Point3 &a = network.nodes[one.from], &b = network.nodes[one.to];
  Place place{piece, a, 0., one.from};
  if (one.corner) { // a rigid part that turns: at its ends alone
    if (point.distance(b) < point.distance(a))
      place = {piece, b, 0., one.to};
  } else {
    const Vector3 way = b - a;
    const double length = way.norm(), s = (point - a) * way / length;
    if (s >= length - tolerance)
      place = {piece, b, 0., one.to};
    else if (s > tolerance)
      place = {piece, Point3(a + (s / length) * way), 0., {}};
  }
  place.distance = place.position.distance(point);
  return place;
}

PlaceOnPieces::Place PlaceOnPieces::on_arc(const std::size_t piece, const Point3 &point) const {
  const Piece &one = network.pieces[piece];
  const Point3 &a = network.nodes[one.from], &b = network.nodes[one.to], &corner = *one.corner;
  const Vector3 u = (a - corner) / (a - corner).norm(), v = (b - corner) / (b - corner).norm();
  const Vector3 bisector = (u + v) / (u + v).norm();
  const double half = std::acos(bisector * u); // between bisector and tangent
  const Point3 centre(corner + (one.radius / std::sin(half)) * bisector);
  // In the bend's plane, seen from its centre: -bisector is its middle.
  Vector3 across = u - (u * bisector) * bisector;
  across /= across.norm();
  const Vector3 to = point - centre;
  const double largest = 3.14159265358979323846 / 2. - half;
  const double angle = std::atan2(to * across, -(to * bisector));
  Place place{piece, a, 0., one.from};
  const double edge = largest - tolerance / one.radius;
  if (angle <= -edge)
    place = {piece, b, 0., one.to};
  else if (angle < edge) {
    place.in_the_middle = std::abs(angle) * one.radius <= tolerance;
    const double at = place.in_the_middle ? 0. : angle;
    place.position =
        Point3(centre + one.radius * (std::sin(at) * across - std::cos(at) * bisector));
    place.node.reset();
  }
  place.distance = place.position.distance(point);
  return place;
}

} // namespace frictionbeam::import
