// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/gmsh/bend_of_file.h"

#include "base/user_error.h"
#include "scene/in_units.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Of the radius: how far it may miss the one that is given, and nodes the circle.
constexpr double miss_of_radius = 0.01, miss_of_node = 1e-3;

struct Circle {
  Point3 centre;
  double radius = 0.; ///< [m]; 0: the points are on a straight line
  Vector3 axis;       ///< unit, about which the points follow each other
};

/// From a, with u and v to b and c and w = u x v: w x (|v|^2 u - |u|^2 v) / (2 |w|^2) leads to the
/// centre.
Circle circle_through(const Point3 &a, const Point3 &b, const Point3 &c) {
  const Vector3 u = b - a, v = c - a, w = cross_product_3d(u, v);
  if (!(w.norm() > 1e-9 * u.norm() * v.norm()))
    return {};
  const Vector3 to_centre =
      cross_product_3d(w, v.norm_square() * u - u.norm_square() * v) / (2. * w.norm_square());
  return {a + to_centre, to_centre.norm(), w / w.norm()};
}

[[noreturn]] void refuse(const Scene &scene, const Pipe &pipe, const std::string &read,
                         const std::string &allowed, const std::string &advice) {
  throw UserError("Pipe " + pipe.name + "/Bend radius: the physical curve '" + pipe.name +
                  "' of '" + scene.mesh.file + "' is no such bend.\n  read:    " + read +
                  "\n  allowed: " + allowed + "\n  try:     " + advice);
}

} // namespace

std::optional<Arc> arc_among(const std::vector<Point3> &nodes, const double largest_radius) {
  constexpr double longest_chord = 0.6; // of the radius: four corners of a loop are no arc
  for (std::size_t i = 0; i + 3 < nodes.size(); ++i) {
    const Circle circle = circle_through(nodes[i], nodes[i + 1], nodes[i + 2]);
    const Vector3 last = nodes[i + 3] - circle.centre;
    if (!(circle.radius > 0.) || circle.radius > largest_radius ||
        std::abs(last.norm() - circle.radius) > miss_of_node * circle.radius ||
        std::abs(last * circle.axis) > miss_of_node * circle.radius)
      continue;
    const auto is_short = [&](const std::size_t cell) {
      return nodes[cell].distance(nodes[cell + 1]) < longest_chord * circle.radius;
    };
    if (is_short(i) && is_short(i + 1) && is_short(i + 2))
      return Arc{nodes[i], circle.radius};
  }
  return {};
}

std::vector<PipePath::Segment> arcs_of_bend(const Scene &scene, const Pipe &pipe,
                                            std::vector<Point3> &nodes) {
  const std::size_t last = nodes.size() - 1;
  if (last < 2)
    refuse(scene, pipe, "one straight cell, which has no plane to bend in",
           "two cells or more of one arc",
           "Transfinite Curve {tag} = 3 in a .geo file, a finer .msh file");
  const bool is_ring = nodes.front() == nodes.back();
  const Circle circle = is_ring && last > 2
                            ? circle_through(nodes[0], nodes[last / 3], nodes[2 * last / 3])
                            : circle_through(nodes[0], nodes[last / 2], nodes[last]);
  const auto length = [&](const double value) { return in_units(scene.units, value, "m"); };
  if (!(std::abs(circle.radius - pipe.bend_radius) <= miss_of_radius * pipe.bend_radius))
    refuse(scene, pipe,
           length(pipe.bend_radius) + ", and nodes on " +
               (circle.radius > 0. ? "a circle of radius " + length(circle.radius)
                                   : "a straight line"),
           "nodes on one arc of that radius, within a hundredth",
           "the radius of the drawing; a physical curve, and a Pipe, of its own for each bend and "
           "each straight run");

  std::vector<PipePath::Segment> arcs;
  for (std::size_t i = 0; i <= last; ++i) {
    Vector3 inward = circle.centre - nodes[i];
    inward -= (inward * circle.axis) * circle.axis;
    inward /= inward.norm();
    const Point3 on_circle = circle.centre - circle.radius * inward;
    const bool goes_back =
        i > 0 && !(cross_product_3d(nodes[i] - nodes[i - 1], inward) * circle.axis > 0.);
    if (!(on_circle.distance(nodes[i]) <= miss_of_node * circle.radius) || goes_back)
      refuse(scene, pipe,
             "a node at " + in_units(scene.units, nodes[i]) + ", " +
                 length(on_circle.distance(nodes[i])) +
                 " beside the circle through the first, middle and last one" +
                 (goes_back ? ", or back along it" : ""),
             "nodes on one arc, one after the other, within a thousandth of its radius",
             "a physical curve, and a Pipe, of its own for each bend and each straight run");
    if (i > 0 && i < last)
      nodes[i] = on_circle;
    if (i > 0) {
      PipePath::Segment &arc = arcs.back();
      arc.end = nodes[i];
      const Vector3 arm = arc.end - circle.centre;
      arc.length = circle.radius * std::atan2(arm * arc.first_tangent, -(arm * arc.inward));
    }
    if (i < last) {
      PipePath::Segment arc;
      arc.start = arcs.empty() ? 0. : arcs.back().start + arcs.back().length;
      arc.begin = nodes[i];
      arc.radius = circle.radius;
      arc.centre = circle.centre;
      arc.inward = inward;
      arc.first_tangent = cross_product_3d(inward, circle.axis);
      arcs.push_back(arc);
    }
  }
  return arcs;
}

} // namespace frictionbeam
