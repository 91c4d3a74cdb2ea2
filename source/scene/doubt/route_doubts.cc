// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/doubt/route_doubts.h"

#include "scene/in_units.h"
#include "scene/part/fit_bends.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

using namespace dealii;

constexpr double joined = 2e-7;            ///< of the line's extent: a little more than is joined
constexpr double widest = 2e-3;            ///< [m], a gap that rounding to the millimetre explains
constexpr double parallel = 1e-6;          ///< sine of the angle between two runs
constexpr unsigned int most_crossings = 5; ///< that are named

/// The straight part of a leg of a route.
struct Run {
  unsigned int pipe, leg; ///< from the route's point of this number to the next
  Point3 begin, end;

  Vector3 way() const { return end - begin; }
  double length() const { return way().norm(); }
  Point3 at(const double part) const { return begin + part * way(); }
  /// Of the run's length, where it is nearest to a point.
  double part(const Point3 &point) const {
    const double square = way().norm_square();
    return square > 0. ? std::clamp((point - begin) * way() / square, 0., 1.) : 0.;
  }
  Point3 nearest(const Point3 &point) const { return at(part(point)); }
};

/// Where two runs are nearest to each other: parts of their lengths.
std::pair<double, double> nearest_parts(const Run &a, const Run &b) {
  const Vector3 u = a.way(), v = b.way(), w = a.begin - b.begin;
  const double uu = u * u, uv = u * v, vv = v * v, determinant = uu * vv - uv * uv;
  double s = 0.;
  if (determinant > parallel * parallel * uu * vv)
    s = std::clamp((uv * (v * w) - vv * (u * w)) / determinant, 0., 1.);
  const double t = b.part(a.at(s));
  s = a.part(b.at(t));
  return {s, b.part(a.at(s))};
}

class RouteDoubts {
public:
  explicit RouteDoubts(Scene &scene) : scene(scene) {
    for (unsigned int p = 0; p < scene.pipes.size(); ++p)
      for (unsigned int i = 0; i + 1 < route(p).size(); ++i) {
        const Vector3 way = route(p)[i + 1].position - route(p)[i].position;
        if (way.norm() > 0.)
          runs.push_back({p, i, route(p)[i].position + taken(p, i) * way / way.norm(),
                          route(p)[i + 1].position - taken(p, i + 1) * way / way.norm()});
      }
    if (runs.empty())
      return;
    std::vector<std::pair<BoundingBox<3>, unsigned int>> boxes;
    for (unsigned int i = 0; i < runs.size(); ++i)
      boxes.emplace_back(BoundingBox<3>(std::vector<Point<3>>{runs[i].begin, runs[i].end}), i);
    BoundingBox<3> line = boxes.front().first;
    for (auto &box : boxes) {
      line.merge_with(box.first);
      box.first.extend(widest);
    }
    const auto &[low, high] = line.get_boundary_points();
    same = joined * (high - low).norm();
    tree = pack_rtree(boxes);
  }

  void of_corners() {
    for (unsigned int p = 0; p < scene.pipes.size(); ++p)
      for (unsigned int i = 1; i + 1 < route(p).size(); ++i) {
        const Pipe &pipe = scene.pipes[p];
        const RoutePoint &corner = route(p)[i];
        const double radius = scene.sections[pipe.section].outer_radius;
        if (corner.bend_radius > 0. && corner.bend_radius < radius)
          say("Pipe " + pipe.name + ": the bend at " + place(corner) + " has a radius of " +
              length(corner.bend_radius) + ", less than the pipe's own of " + length(radius) +
              ": its wall would cross itself. Try the radius of the bend's axis.");
        const Vector3 before = corner.position - route(p)[i - 1].position,
                      after = route(p)[i + 1].position - corner.position;
        if (corner.bend_radius == 0. &&
            cross_product_3d(before, after).norm() <= parallel * before.norm() * after.norm() &&
            before * after < 0.)
          say("Pipe " + pipe.name + ": at " + place(corner) +
              " its route turns back by 180 degrees and runs over itself, joined at the corner "
              "alone. Look at the coordinates of the points there.");
      }
  }

  /// Of pipes that pass through each other, and of one through itself, where no route has a point
  /// that joins them; where one of two pipes has one, the mesh says what it makes of it.
  void of_crossings() {
    std::vector<std::string> found;
    for (unsigned int i = 0; i < runs.size(); ++i)
      for (const auto &[box, k] : tree | boost::geometry::index::adaptors::queried(
                                             boost::geometry::index::intersects(box_of(runs[i]))))
        if (k < i)
          if (const std::string text = crossing(runs[k], runs[i]); !text.empty())
            found.push_back(text);
    for (unsigned int i = 0; i < std::min<std::size_t>(found.size(), most_crossings); ++i)
      say(found[i]);
    if (found.size() > most_crossings)
      say("Pipes pass through one another and are not joined at " +
          std::to_string(found.size() - most_crossings) + " more places.");
  }

  /// Of ends that miss another pipe; of two that miss each other, once.
  void of_near_ends() {
    const std::vector<Point3> connected = connected_places();
    std::vector<Point3> said;
    const auto is_one_of = [](const std::vector<Point3> &places, const Point3 &end,
                              const double tolerance) {
      return std::any_of(places.begin(), places.end(),
                         [&](const Point3 &other) { return other.distance(end) <= tolerance; });
    };
    for (unsigned int p = 0; p < scene.pipes.size(); ++p)
      for (const bool at_end : {false, true}) {
        if (route(p).size() < 2)
          continue;
        const RoutePoint &end = at_end ? route(p).back() : route(p).front();
        double gap = 0.;
        const Run *const nearest = nearest_of_others(p, at_end, gap);
        if (nearest == nullptr || gap <= same || is_one_of(connected, end.position, same) ||
            is_one_of(said, end.position, widest))
          continue;
        said.push_back(end.position);
        const Point3 foot = nearest->nearest(end.position);
        const RoutePoint *at = nullptr;
        for (const unsigned int i : {nearest->leg, nearest->leg + 1})
          if (route(nearest->pipe)[i].position.distance(foot) <= widest)
            at = &route(nearest->pipe)[i];
        say("Pipe " + scene.pipes[p].name + (at_end ? " ends at " : " begins at ") + place(end) +
            ", " + length(gap) + " from pipe " + scene.pipes[nearest->pipe].name + " at " +
            (at == nullptr ? in_units(scene.units, foot) : place(*at)) +
            ", and is not joined to it. Try the same coordinates, or the name of that point "
            "alone.");
      }
  }

private:
  const std::vector<RoutePoint> &route(const unsigned int pipe) const {
    return scene.pipes[pipe].route;
  }
  /// What a bend takes of the legs that meet there [m].
  double taken(const unsigned int pipe, const unsigned int corner) const {
    return tangent_length(route(pipe), corner);
  }
  void say(const std::string &text) { scene.doubts.push_back(text); }
  std::string length(const double metres) const { return in_units(scene.units, metres, "m"); }
  std::string place(const RoutePoint &point) const {
    return (point.name.empty() ? "" : "'" + point.name + "' ") +
           in_units(scene.units, point.position);
  }
  static BoundingBox<3> box_of(const Run &run) {
    return BoundingBox<3>(std::vector<Point<3>>{run.begin, run.end});
  }

  /// Whether a run's place is an end of its pipe.
  bool is_end(const Run &run, const double part) const {
    return (run.leg == 0 && part * run.length() <= same) ||
           (run.leg + 2 == route(run.pipe).size() && (1. - part) * run.length() <= same);
  }
  bool is_inside(const Run &run, const double part) const {
    return part * run.length() > same && (1. - part) * run.length() > same;
  }

  /// What to say of two runs; empty if they are apart or meet in what the mesh joins.
  std::string crossing(const Run &a, const Run &b) const {
    const bool is_own = a.pipe == b.pipe;
    const bool are_parallel = cross_product_3d(a.way(), b.way()).norm() <=
                              parallel * a.length() * b.length(); // the mesh says how they overlap
    if (is_own ? b.leg == a.leg + 1 : are_parallel)
      return "";
    const auto [s, t] = nearest_parts(a, b);
    const bool meets = a.at(s).distance(b.at(t)) <= same,
               either = is_inside(a, s) || is_inside(b, t),
               both = is_inside(a, s) && is_inside(b, t);
    if (!meets || (is_own ? !either || is_end(a, s) || is_end(b, t) : !both))
      return "";
    const std::string where = in_units(scene.units, a.at(s));
    return (is_own ? "Pipe " + scene.pipes[a.pipe].name + " passes through itself at " + where
                   : "Pipes " + scene.pipes[a.pipe].name + " and " + scene.pipes[b.pipe].name +
                         " pass through one another at " + where) +
           " and " + (is_own ? "is" : "are") + " not joined there. To join what meets, " +
           (is_own ? "give its route that point both times" : "give both routes that point") +
           "; or look at the coordinates.";
  }

  /// The run of another pipe that is nearest to an end, within a gap that rounding explains.
  const Run *nearest_of_others(const unsigned int pipe, const bool at_end, double &gap) const {
    const std::vector<RoutePoint> &points = route(pipe);
    const std::size_t n = points.size();
    const Point3 &end = points[at_end ? n - 1 : 0].position;
    gap = largest_overlap(end.distance(points[at_end ? n - 2 : 1].position));
    const Run *nearest = nullptr;
    for (const auto &[box, i] :
         tree | boost::geometry::index::adaptors::queried(boost::geometry::index::intersects(end)))
      if (runs[i].pipe != pipe)
        if (const double distance = runs[i].nearest(end).distance(end); distance <= gap) {
          gap = distance;
          nearest = &runs[i];
        }
    return nearest;
  }

  /// Places that a spring or a support on a pipe joins to others, as the user means it.
  std::vector<Point3> connected_places() const {
    std::vector<std::string> names;
    for (const Spring &spring : scene.springs)
      if (!spring.other.empty())
        names.insert(names.end(), {spring.point, spring.other});
    for (const FrictionSupport &support : scene.supports)
      if (!support.ground.empty()) {
        names.push_back(support.ground);
        names.insert(names.end(), support.placement.points.begin(), support.placement.points.end());
      }
    std::vector<Point3> places;
    for (const std::string &name : names)
      if (const auto found = scene.places.find(name); found != scene.places.end())
        places.push_back(found->second);
    return places;
  }

  Scene &scene;
  std::vector<Run> runs;
  double same = 0.; ///< [m], below which two places are one
  RTree<std::pair<BoundingBox<3>, unsigned int>> tree;
};

} // namespace

void doubt_routes(Scene &scene) {
  RouteDoubts doubts(scene);
  doubts.of_corners();
  doubts.of_crossings();
  doubts.of_near_ends();
}

} // namespace frictionbeam
