// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/pipe_junctions.h"

#include "mesh/point_set.h"

#include "scene/in_units.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr unsigned int most_remarks = 10; ///< of a kind

/// A pipe at a place.
struct Strand {
  unsigned int pipe;
  double s;
  bool in_route;    ///< its route has a point there
  std::string name; ///< of that point; may be empty
};

/// A place where some route has a point, or a section Point stands.
struct Location {
  Point3 position;
  std::vector<Strand> strands;
  std::vector<std::string> points; ///< of the sections Point there
};

/// Distance along a path to the end of its straight run or bend, forwards or backwards.
double reach(const PipePath &path, const double s, const bool forwards, const double tolerance) {
  for (const PipePath::Segment &segment : path.segments()) {
    const double end = segment.start + segment.length;
    if (forwards ? s >= segment.start - tolerance && s < end - tolerance
                 : s > segment.start + tolerance && s <= end + tolerance)
      return forwards ? end - s : s - segment.start;
  }
  return 0.;
}

/// Whether two paths that meet run together on one axis from there, on either side.
bool overlap(const PipePath &a, const double s_a, const PipePath &b, const double s_b,
             const double tolerance) {
  for (const bool forwards_a : {false, true})
    for (const bool forwards_b : {false, true}) {
      const double length =
          std::min(reach(a, s_a, forwards_a, tolerance), reach(b, s_b, forwards_b, tolerance)) / 2.;
      if (length > 20. * tolerance &&
          a.point(s_a + (forwards_a ? length : -length))
                  .distance(b.point(s_b + (forwards_b ? length : -length))) <= 10. * tolerance)
        return true;
    }
  return false;
}

/// The straight runs and bends of all pipes, found by where they are.
class Segments {
public:
  Segments(const std::vector<PipePath> &paths, const double tolerance)
      : paths(paths), tolerance(tolerance) {
    std::vector<std::pair<BoundingBox<3>, Number>> boxes;
    for (unsigned int p = 0; p < paths.size(); ++p)
      for (unsigned int i = 0; i < paths[p].segments().size(); ++i)
        boxes.push_back({box_of(paths[p].segments()[i]), {p, i}});
    tree = pack_rtree(boxes);
  }

  /// The pipes that reach a position, and their arc lengths there, rising.
  std::vector<std::pair<unsigned int, double>> places(const Point3 &position) const {
    namespace index = boost::geometry::index;
    std::vector<Number> near;
    for (const auto &[box, number] : tree | index::adaptors::queried(index::intersects(position)))
      near.push_back(number);
    std::sort(near.begin(), near.end());
    std::vector<std::pair<unsigned int, double>> result;
    for (const auto &[pipe, i] : near)
      if (const auto s = paths[pipe].segments()[i].place(position, tolerance))
        result.emplace_back(pipe, *s);
    return result;
  }

private:
  using Number = std::pair<unsigned int, unsigned int>; ///< pipe, place among its segments

  BoundingBox<3> box_of(const PipePath::Segment &segment) const {
    std::vector<Point<3>> points = {segment.begin, segment.end};
    if (segment.radius > 0.) // within a diameter of either end
      for (const Point3 &end : {segment.begin, segment.end})
        for (const double sign : {-1., 1.})
          points.push_back(end + 2. * sign * segment.radius * Vector3({1., 1., 1.}));
    BoundingBox<3> box(points);
    box.extend(2. * tolerance);
    return box;
  }

  const std::vector<PipePath> &paths;
  const double tolerance;
  RTree<std::pair<BoundingBox<3>, Number>> tree;
};

/// Finds locations, and decides which of their strands are one.
class Meeting {
public:
  Meeting(const Scene &scene, const std::vector<PipePath> &paths, const double tolerance)
      : scene(scene), paths(paths), tolerance(tolerance), known(tolerance) {
    for (unsigned int p = 0; p < paths.size(); ++p)
      for (const auto &point : paths[p].route_points())
        at(paths[p].point(point.s)).strands.push_back({p, point.s, true, point.name});
    const Segments segments(paths, tolerance);
    for (Location &location : locations)
      add_passing(location, segments);
    for (const NamedPoint &point : scene.points) {
      const unsigned int n_before = locations.size();
      Location &location = at(point.position);
      location.points.push_back(point.name);
      if (locations.size() > n_before)
        add_passing(location, segments);
    }
  }

  std::vector<Location> locations;

  /// For each strand of a location, the first strand that it is joined to. Those whose routes have
  /// a point there come first.
  std::vector<unsigned int> join(const Location &location) {
    const auto &strands = location.strands;
    std::vector<unsigned int> first(strands.size());
    if (!strands[0].in_route) { // a Point alone
      if (strands.size() > 1)
        joined.push_back("pipes " + pipes_of(location) + " at the point '" +
                         location.points.front() + "' " + in_units(scene.units, location.position) +
                         ", which is in no route");
      note_overlaps(location, strands.size());
      return first;
    }
    unsigned int n_in_route = 0;
    for (unsigned int i = 0; i < strands.size(); ++i) {
      first[i] = strands[i].in_route || meets(location, strands[i]) ? 0 : i;
      n_in_route += strands[i].in_route ? 1 : 0;
    }
    note_overlaps(location, n_in_route);
    return first;
  }

  std::vector<std::string> remarks() const {
    std::vector<std::string> texts;
    add(joined, "Joined: ", texts);
    add(apart, "Not joined: ", texts);
    std::vector<std::string> both;
    for (const auto &[pipes, places] : overlapping) {
      std::string where;
      for (const std::string &place : places)
        where += (where.empty() ? "" : ", ") + place;
      both.push_back("pipes '" + scene.pipes[pipes.first].name + "' and '" +
                     scene.pipes[pipes.second].name +
                     "' overlap on one axis and are two pipes there, joined " +
                     (where.empty() ? "nowhere on it" : "only at " + where));
    }
    add(both, "Overlap: ", texts);
    return texts;
  }

private:
  Location &at(const Point3 &position) {
    const unsigned int i = known.insert(position);
    if (i == locations.size())
      locations.push_back({position, {}, {}});
    return locations[i];
  }

  /// Strands of pipes that pass a location where their routes have no point.
  void add_passing(Location &location, const Segments &segments) const {
    const std::vector<Strand> in_route = location.strands;
    if (paths.size() == 1 && !in_route.empty() && !ends_at(in_route, 0))
      return; // a pipe meets itself at its ends only
    const auto passes = [&](const unsigned int pipe) {
      return ends_at(in_route, pipe) ||
             std::none_of(in_route.begin(), in_route.end(),
                          [&](const Strand &strand) { return strand.pipe == pipe; });
    };
    for (const auto &[pipe, s] : segments.places(location.position))
      if (passes(pipe) && std::none_of(location.strands.begin(), location.strands.end(),
                                       [&, pipe = pipe, s = s](const Strand &strand) {
                                         return strand.pipe == pipe &&
                                                std::abs(strand.s - s) <= 2. * tolerance;
                                       }))
        location.strands.push_back({pipe, s, false, ""});
  }

  bool is_end(const Strand &strand) const {
    return strand.in_route &&
           (strand.s <= tolerance || strand.s >= paths[strand.pipe].length() - tolerance);
  }
  bool ends_at(const std::vector<Strand> &strands, const unsigned int pipe) const {
    return std::any_of(strands.begin(), strands.end(),
                       [&](const Strand &strand) { return strand.pipe == pipe && is_end(strand); });
  }

  bool run_together(const Strand &a, const Strand &b) const {
    return overlap(paths[a.pipe], a.s, paths[b.pipe], b.s, tolerance);
  }

  static std::pair<unsigned int, unsigned int> pair(const Strand &a, const Strand &b) {
    return std::minmax({a.pipe, b.pipe});
  }

  /// The first @p n strands of a location are joined: on one axis, that is to be said.
  void note_overlaps(const Location &location, const unsigned int n) {
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int k = 0; k < i; ++k) {
        const Strand &a = location.strands[k], &b = location.strands[i];
        if (a.pipe != b.pipe && run_together(a, b))
          overlapping[pair(a, b)].insert(describe(location));
      }
  }

  /// Whether a pipe that only passes is joined to those whose routes have a point there.
  bool meets(const Location &location, const Strand &passing) {
    bool one_ends = false, together = false;
    const Strand *other = nullptr;
    for (const Strand &strand : location.strands)
      if (strand.in_route) {
        if (other == nullptr || (is_end(strand) && !one_ends))
          other = &strand;
        one_ends = one_ends || is_end(strand);
        if (run_together(strand, passing)) {
          together = true;
          if (strand.pipe != passing.pipe)
            overlapping[pair(strand, passing)];
        }
      }
    if (together)
      return false;
    const std::string pipes = "pipe '" + scene.pipes[passing.pipe].name + "' and pipe '" +
                              scene.pipes[other->pipe].name + "'",
                      where = describe(location);
    if (one_ends || !location.points.empty()) {
      joined.push_back(pipes + " at " + where + ", " +
                       (one_ends ? "where the second one ends inside a run of the first"
                                 : "which lies on both"));
      return true;
    }
    apart.push_back(pipes + " pass through one another at " + where +
                    ", a point of the second one's route alone. To join them, give both routes "
                    "that point");
    return false;
  }

  std::string describe(const Location &location) const {
    std::string name = location.points.empty() ? "" : location.points.front();
    for (const Strand &strand : location.strands)
      if (name.empty())
        name = strand.name;
    return (name.empty() ? "" : "'" + name + "' ") + in_units(scene.units, location.position);
  }

  std::string pipes_of(const Location &location) const {
    std::string text;
    for (unsigned int i = 0; i < location.strands.size(); ++i)
      text += std::string(i == 0                             ? ""
                          : i + 1 == location.strands.size() ? " and "
                                                             : ", ") +
              "'" + scene.pipes[location.strands[i].pipe].name + "'";
    return text;
  }

  static void add(const std::vector<std::string> &sentences, const std::string &what,
                  std::vector<std::string> &texts) {
    for (unsigned int i = 0; i < std::min<std::size_t>(sentences.size(), most_remarks); ++i)
      texts.push_back(what + sentences[i] + ".");
    if (sentences.size() > most_remarks)
      texts.push_back(what + "the same at " + std::to_string(sentences.size() - most_remarks) +
                      " more places.");
  }

  const Scene &scene;
  const std::vector<PipePath> &paths;
  const double tolerance;
  PointSet known;
  std::vector<std::string> joined, apart;
  std::map<std::pair<unsigned int, unsigned int>, std::set<std::string>> overlapping;
};

} // namespace

PipeJunctions::PipeJunctions(const Scene &scene, const std::vector<PipePath> &paths,
                             const double tolerance)
    : tolerance(tolerance), list(paths.size()) {
  Meeting meeting(scene, paths, tolerance);
  for (const Location &location : meeting.locations) {
    if (location.strands.empty())
      continue;
    const auto &strands = location.strands;
    const std::vector<unsigned int> first = meeting.join(location);
    const unsigned int begin = n;
    std::map<unsigned int, unsigned int> number; // by the first strand
    for (unsigned int i = 0; i < strands.size(); ++i)
      if (strands[i].in_route || first[i] == 0) // else it passes by and needs no vertex
        list[strands[i].pipe].push_back(
            {strands[i].s, begin + number.try_emplace(first[i], number.size()).first->second});
    n += number.size();
    for (const std::string &point : location.points) {
      const auto own = std::find_if(strands.begin(), strands.end(),
                                    [&](const Strand &strand) { return strand.name == point; });
      const Strand &strand = own == strands.end() ? strands.front() : *own;
      places[point] = {strand.pipe, strand.s};
    }
  }
  for (std::vector<Node> &nodes : list)
    std::sort(nodes.begin(), nodes.end(), [](const Node &a, const Node &b) { return a.s < b.s; });
  texts = meeting.remarks();
}

std::optional<unsigned int> PipeJunctions::node(const unsigned int pipe, const double s) const {
  const auto &nodes = list[pipe];
  const auto near =
      std::lower_bound(nodes.begin(), nodes.end(), s - tolerance,
                       [](const Node &node, const double value) { return node.s < value; });
  if (near == nodes.end() || near->s > s + tolerance)
    return {};
  return near->number;
}

std::optional<PipeJunctions::Place> PipeJunctions::place(const std::string &point) const {
  const auto found = places.find(point);
  if (found == places.end())
    return {};
  return found->second;
}

} // namespace frictionbeam
