// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/catalogue/catalogue_entries.h"
#include "scene/part/fit_bends.h"
#include "scene/part/parts.h"

#include "scene/in_units.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace frictionbeam::parts {

std::vector<std::string> point_names(const Scene &scene) {
  std::vector<std::string> result = names(scene.points);
  std::set<std::string> known(result.begin(), result.end());
  for (const Pipe &pipe : scene.pipes)
    for (const RoutePoint &point : pipe.route)
      if (!point.name.empty() && known.insert(point.name).second)
        result.push_back(point.name);
  return result;
}

void check_point(const ParameterReader &in, const std::string &entry, const std::string &name,
                 Scene &scene) {
  if (!scene.mesh.file.empty() && !name.empty())
    scene.asked_points.push_back({in.where(entry), name});
  else if (scene.places.count(name) == 0)
    in.find(entry, name, point_names(scene), "point");
}

std::vector<std::string> points_at(const ParameterReader &in, Scene &scene) {
  const std::vector<std::string> points = in.list("At");
  std::set<std::string> known;
  for (const std::string &point : points) {
    check_point(in, "At", point, scene);
    if (!known.insert(point).second)
      in.fail("At", "every point once", "removing one '" + point + "'");
  }
  return points;
}

void declare_point(ParameterReader &in) {
  in.declare_text("Position", "0 0 0", "x y z [m]",
                  "Of a named point on a pipe, or free in space for springs, masses and supports "
                  "without a pipe.");
}

void parse_point(const ParameterReader &in, const std::string &name, Scene &scene) {
  scene.add_point(name, Point3(in.vector("Position", "m")));
}

void declare_pipe(ParameterReader &in) {
  in.declare_text("Section", "", "name of a section", "May be left out if there is only one.");
  in.declare_text("Material", "", "name of a material", "May be left out if there is only one.");
  in.declare_text(
      "Route", "",
      "points separated by ';', each: name x y z [m], name by dx dy dz [m], x y z or "
      "name, and then bend R [m] if the corner is rounded",
      "The pipe's course, straight from corner to corner. 'by' counts from the point before; a "
      "name "
      "alone is a point that a Point or a pipe further up has placed (a tee). The name of a bend's "
      "corner stands for the middle of the bend. Empty: the physical curve of this pipe's name in "
      "Mesh/File.");
  in.declare_text(
      "Bend flexibility", "code", "code, von Karman, none, or a number >= 1 [-]",
      "How many times more flexible than a straight pipe a bend is. code: k = 1.65/h, at "
      "least 1, h = t R/r^2 (ASME B31.3, appendix D); von Karman: (10 + 12 h^2)/(1 + 12 h^2).");
  in.declare_number(
      "Stiffening pressure", 0., "Pa", 0., 1e300,
      "Inside, makes bends stiffer: k and the stress intensification factors of B31.3 "
      "are divided as its appendix D says.");
  in.declare_text("End section", "", "name of a section",
                  "Of a reducer: diameter and wall go evenly from Section to this one.");
  in.declare_text(
      "Item", "", "name of an item of Catalogue/Components",
      "A valve, a flange of your own table: the pipe is rigid, has the item's mass, and "
      "its route must be as long as the item.");
  in.declare_flag("Rigid", false, "A valve, a flange: 1000 times as stiff as its section.");
  in.declare_number(
      "Mass", -1., "kg", -1., 1e300,
      "Of the pipe's own, of a valve, instead of its metal's; contents and insulation "
      "come on top. -1: by density.");
  in.declare_number(
      "Bend radius", 0., "m", 0., 1e300,
      "Of a pipe from Mesh/File that is one bend: its nodes, three or more, lie on an arc of this "
      "radius, within a hundredth, and it is what a bend of a route is. 0: it is straight.");
}

namespace {

constexpr double tolerance = 1e-9;

[[noreturn]] void fail_point(const ParameterReader &in, const std::string &text,
                             const std::string &allowed, const std::string &hint) {
  in.fail("Route", allowed, hint, "'" + text + "'");
}

/// One point of a route.
RoutePoint parse_route_point(const ParameterReader &in, const std::string &text, const Scene &scene,
                             const Pipe &pipe) {
  const std::string form = "name x y z, name by dx dy dz, x y z, or the name of a point that is "
                           "placed already; then bend R";
  std::vector<std::string> words = split(text, ' ');
  RoutePoint point;
  if (words.size() >= 2 && words[words.size() - 2] == "bend") {
    if (!to_number(words.back(), point.bend_radius) || point.bend_radius <= 0.)
      fail_point(in, text, "bend R with a radius > 0 [m]", "bend 0.457");
    point.bend_radius = in.in_bounds("Route", point.bend_radius * in.si("m"), "m");
    words.resize(words.size() - 2);
  }
  const bool relative = words.size() >= 4 && words[words.size() - 4] == "by";
  if (words.empty() || words.size() == 2 || words.size() > (relative ? 5 : 4))
    fail_point(in, text, form, "'P1 0 0 0'");
  if (relative)
    words.erase(words.end() - 4);
  if (words.size() != 3) {
    point.name = words[0];
    words.erase(words.begin());
  }
  const auto placed = scene.places.find(point.name); // already there
  const Point3 *const known = placed == scene.places.end() ? nullptr : &placed->second;
  if (words.empty()) {
    if (known == nullptr) {
      const std::string like = nearest(point.name, point_names(scene));
      fail_point(in, text, form,
                 like.empty() ? "coordinates after the name; it has none up to here"
                              : "'" + like + "'");
    }
    point.position = *known;
    return point;
  }
  for (unsigned int d = 0; d < 3; ++d)
    if (!to_number(words[d], point.position[d]))
      fail_point(in, text, form, "a number in place of '" + words[d] + "'");
    else
      point.position[d] = in.in_bounds("Route", point.position[d] * in.si("m"), "m");
  if (relative) {
    if (pipe.route.empty())
      fail_point(in, text, "'by' from the second point on", "the first point's coordinates");
    point.position += pipe.route.back().position;
  }
  if (known != nullptr && known->distance(point.position) > tolerance)
    fail_point(in, text,
               "one place for each name; '" + point.name + "' is at " + to_text((*known)[0]) + " " +
                   to_text((*known)[1]) + " " + to_text((*known)[2]),
               "another name, or the name alone to come back to that point");
  return point;
}

std::string name_of(const std::vector<RoutePoint> &route, const unsigned int i) {
  return route[i].name.empty() ? "point " + std::to_string(i + 1) : "'" + route[i].name + "'";
}

/// What bends need of their corner.
void check_corner(const ParameterReader &in, const std::vector<RoutePoint> &route,
                  const unsigned int i) {
  const RoutePoint &corner = route[i];
  if (corner.bend_radius == 0.)
    return;
  const std::string which = "the bend at " + name_of(route, i);
  if (i == 0 || i + 1 == route.size())
    fail_point(in, which, "bends between two points of a route", "removing 'bend' at its end");
  const Vector3 a = corner.position - route[i - 1].position,
                b = route[i + 1].position - corner.position;
  if (a * b < (-1. + 1e-9) * a.norm() * b.norm())
    fail_point(in, which, "corners of less than 180 degrees", "a route that does not turn back");
}

/// Bends that overlap by the rounding of their dimensions are made to meet, which is said.
void fit_route(const ParameterReader &in, const std::string &pipe, std::vector<RoutePoint> &route,
               Scene &scene) {
  const auto length = [&](const double value) { return in_units(scene.units, value, "m"); };
  const std::vector<RoutePoint> given = route;
  std::optional<BendOverlap> too_long;
  const std::vector<BendOverlap> met = fit_bends(route, too_long);
  if (too_long) {
    const unsigned int i = too_long->leg,
                       corner =
                           tangent_length(route, i) >= tangent_length(route, i + 1) ? i : i + 1;
    const double leg = route[i].position.distance(route[i + 1].position);
    fail_point(in,
               "bend " + to_text(route[corner].bend_radius / in.si("m")) + " at " +
                   name_of(route, corner),
               "bends that fit their legs: from point " + std::to_string(i + 1) + " to " +
                   std::to_string(i + 2) + " there are " + length(leg) + ", the bends take " +
                   length(leg + too_long->overlap) + "; " + length(largest_overlap(leg)) +
                   " more than there are pass for rounding",
               "a smaller radius, or points further apart");
  }
  for (const BendOverlap &overlap : met) {
    std::string text;
    for (const unsigned int i : {overlap.leg, overlap.leg + 1})
      if (given[i].bend_radius > 0.)
        text += (text.empty() ? "" : ", ") + name_of(route, i) + " " +
                length(route[i].bend_radius) + " instead of " + length(given[i].bend_radius);
    scene.remarks.push_back("Pipe " + pipe + ": from point " + std::to_string(overlap.leg + 1) +
                            " to " + std::to_string(overlap.leg + 2) +
                            " of its route the bends take " + length(overlap.overlap) +
                            " more than there is, which passes for the rounding of a "
                            "drawing: they were made to meet, with these radii: " +
                            text + ".");
  }
}

void check_route(const ParameterReader &in, const std::vector<RoutePoint> &route) {
  if (route.size() < 2)
    in.fail("Route", "at least two points, separated by ';'", "'P1 0 0 0; P2 by 6 0 0'");
  for (unsigned int i = 0; i + 1 < route.size(); ++i)
    if (route[i].position.distance(route[i + 1].position) < tolerance)
      fail_point(in,
                 "points " + std::to_string(i + 1) + " and " + std::to_string(i + 2) +
                     " at the same place",
                 "points apart from each other", "removing one of them");
  for (unsigned int i = 0; i < route.size(); ++i)
    check_corner(in, route, i);
}

/// The part that an entry names; the only one if the entry is empty.
unsigned int one_of(const ParameterReader &in, const std::string &entry,
                    const std::vector<std::string> &names, const std::string &kind) {
  if (in.text(entry).empty() && names.size() == 1)
    return 0;
  return in.find(entry, in.text(entry), names, kind);
}

} // namespace

void parse_pipe(const ParameterReader &in, const std::string &name, Scene &scene) {
  Pipe pipe;
  pipe.name = name;
  pipe.section = one_of(in, "Section", names(scene.sections), "section");
  pipe.material = one_of(in, "Material", names(scene.materials), "material");
  for (const std::string &text : split(in.text("Route"), ';')) {
    if (text.empty())
      continue;
    pipe.route.push_back(parse_route_point(in, text, scene, pipe));
    if (const RoutePoint &point = pipe.route.back(); !point.name.empty())
      scene.places.emplace(point.name, point.position);
  }
  if (!pipe.route.empty() || scene.mesh.file.empty())
    check_route(in, pipe.route);
  if (!pipe.route.empty())
    fit_route(in, name, pipe.route, scene);
  if (!in.text("End section").empty())
    pipe.end_section =
        in.find("End section", in.text("End section"), names(scene.sections), "section");
  if (pipe.end_section && scene.sections[*pipe.end_section].rotary_inertia !=
                              scene.sections[pipe.section].rotary_inertia)
    in.fail("End section", "a section with the same 'Rotary inertia' as the first",
            "the same in both", in.text("End section"));
  pipe.rigid = in.flag("Rigid");
  if (in.number("Mass") >= 0.)
    pipe.total_mass = in.number("Mass");
  parse_component_of_pipe(in, scene, pipe);
  pipe.bend_radius = in.number("Bend radius");
  if (pipe.bend_radius > 0. && !pipe.route.empty())
    in.fail("Bend radius", "a radius here for pipes from Mesh/File only",
            "'bend " + to_text(pipe.bend_radius) + "' at a corner of the route");

  const std::string flexibility = in.text("Bend flexibility");
  using Rule = BendFlexibility::Rule;
  BendFlexibility &bend = pipe.bend_flexibility;
  bend.pressure = in.number("Stiffening pressure");
  if (flexibility == "none")
    bend.rule = Rule::none;
  else if (flexibility == "code" || flexibility == "von Karman") {
    bend.rule = flexibility == "code" ? Rule::code : Rule::von_karman;
    const bool bends = pipe.bend_radius > 0. || pipe.has_bend();
    if (bends && scene.sections[pipe.section].wall == 0.)
      in.fail("Bend flexibility",
              flexibility + " where the section gives 'Outer diameter' and 'Wall'",
              "none, a number, or a section with diameter and wall", "code");
  } else {
    bend.rule = Rule::given;
    if (!to_number(flexibility, bend.factor) || bend.factor < 1.)
      in.fail("Bend flexibility", "code, von Karman, none, or a number >= 1", "code");
  }
  scene.pipes.push_back(pipe);
}

} // namespace frictionbeam::parts
