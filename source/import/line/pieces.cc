// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/pieces.h"

#include "base/number_text.h"
#include "import/line/bend_geometry.h"
#include "import/line/place_on_pieces.h"
#include "mesh/point_set.h"

#include <cmath>

namespace frictionbeam::import {

namespace {

constexpr double least_to_say = 1e-6; ///< of an end that was moved [m]
constexpr double least_tolerance = 1e-8;

class PieceMaker {
public:
  PieceMaker(const PcfFile &file, const PcfLine &line, const double tolerance,
             SectionPlanner &sections, Notes &notes)
      : file(file), line(line), tolerance(std::max(tolerance, least_tolerance)), sections(sections),
        notes(notes), points(this->tolerance) {}

  Network make() {
    for (std::size_t i = 0; i < line.components.size(); ++i)
      add(i);
    network.nodes = points.points;
    for (const std::size_t i : olets)
      add_olet(i);
    check_doubles();
    for (std::size_t i = 0; i < line.components.size(); ++i)
      if (const Shape shape = line.components[i].shape;
          shape == Shape::support || shape == Shape::joint)
        place(i);
    return std::move(network);
  }

private:
  unsigned int node(const PcfPoint &point, const PcfComponent &component) {
    const Point3 wanted = on_grid(point.position);
    const unsigned int number = points.insert(wanted);
    if (const double way = points.points[number].distance(wanted); way > least_to_say)
      notes.moved.push_back({point.line, component.keyword + ": an end was moved by " +
                                             rounded_number(1e3 * way) + " mm to " +
                                             text_of_place(points.points[number])});
    return number;
  }

  void add(const std::size_t i) {
    const PcfComponent &component = line.components[i];
    switch (component.shape) {
    case Shape::olet:
      olets.push_back(i);
      return;
    case Shape::tee:
      add_with_branches(i, false);
      return;
    case Shape::end:
      add_rigid(i);
      return;
    case Shape::rigid:
      if (component.branches.empty())
        add_rigid(i);
      else
        add_with_branches(i, true);
      return;
    case Shape::bend:
      add_later(i);
      if (turns_back(line, component, tolerance)) {
        add_return(i);
        return;
      }
      add_run(i);
      return;
    case Shape::reducer:
      add_later(i);
      add_run(i);
      return;
    case Shape::pipe:
      add_run(i);
      return;
    default:
      return; // placed on the line when there is one
    }
  }

  /// The branch of a bend or reducer that has one, when all of the line is there.
  void add_later(const std::size_t i) {
    const PcfComponent &component = line.components[i];
    if (component.branches.empty())
      return;
    if (component.centre && component.kind != nullptr && component.kind->tee_kind != nullptr)
      olets.push_back(i);
    else
      notes.not_understood.push_back(
          {component.line, component.keyword + ": its branch, without a CENTRE-POINT; left out"});
  }

  Piece piece_of(const std::size_t i, const unsigned int from, const unsigned int to) {
    const PcfComponent &component = line.components[i];
    Piece piece;
    piece.component = i;
    piece.from = from;
    piece.to = to;
    piece.section = sections.section(component, component.bore(0));
    piece.material = sections.material(component);
    piece.run = ++n_runs;
    return piece;
  }

  [[noreturn]] void fail_length(const PcfComponent &component, const double length) const {
    file.fail(component.line,
              component.keyword + " of zero length: its ends are " + rounded_number(1e3 * length) +
                  " mm apart, the tolerance is " + rounded_number(1e3 * tolerance) + " mm",
              "ends further apart than the tolerance", "removing it, or a smaller --tolerance");
  }

  void add_run(const std::size_t i) {
    const PcfComponent &component = line.components[i];
    const unsigned int from = node(component.ends[0], component),
                       to = node(component.ends[1], component);
    if (from == to) {
      if (component.kind == nullptr || !component.kind->may_be_point)
        fail_length(component, component.ends[0].position.distance(component.ends[1].position));
      network.masses.push_back({i, from});
      return;
    }
    Piece piece = piece_of(i, from, to);
    if (component.shape == Shape::reducer) {
      if (component.bore(0) == component.bore(1))
        notes.assumed.push_back({component.line, component.keyword + " has one bore at both ends"});
      piece.end_section = sections.section(component, component.bore(1), true);
    }
    if (component.shape == Shape::bend)
      give_bend(file, component, points.points[from], points.points[to], tolerance, piece, notes);
    network.pieces.push_back(piece);
  }

  /// A bend of 180 degrees as two of 90.
  void add_return(const std::size_t i) {
    const PcfComponent &component = line.components[i];
    const unsigned int from = node(component.ends[0], component),
                       to = node(component.ends[1], component);
    if (from == to)
      fail_length(component, component.ends[0].position.distance(component.ends[1].position));
    PcfPoint top;
    top.position = top_of_return(file, line, component, tolerance);
    top.line = component.line;
    const unsigned int middle = node(top, component);
    const Point3 &a = points.points[from], &b = points.points[to], &c = points.points[middle];
    const Vector3 half = 0.5 * (b - a);
    Piece first = piece_of(i, from, middle), second = first;
    second.from = middle;
    second.to = to;
    give_corner(first, a, Point3(c - half), c);
    give_corner(second, c, Point3(c + half), b);
    network.pieces.push_back(first);
    network.pieces.push_back(second);
    notes.assumed.push_back(
        {component.line, component.keyword + " turns by 180 degrees: two bends of 90, its top at " +
                             text_of_place(top.position)});
  }

  void add_rigid(const std::size_t i) {
    const PcfComponent &component = line.components[i];
    const unsigned int from = node(component.ends[0], component),
                       to = node(component.ends.back(), component);
    if (from == to) {
      if (component.ends.size() == 2 && !component.kind->may_be_point)
        fail_length(component, component.ends[0].position.distance(component.ends[1].position));
      network.masses.push_back({i, from});
      return;
    }
    Piece piece = piece_of(i, from, to);
    piece.rigid = true;
    if (component.centre &&
        is_off_line(component.centre->position, points.points[from], points.points[to], tolerance))
      piece.corner = on_grid(component.centre->position);
    network.pieces.push_back(piece);
  }

  /// A run from end to end with branches in the middle.
  void add_with_branches(const std::size_t i, const bool rigid) {
    const PcfComponent &component = line.components[i];
    const Point3 &a = component.ends[0].position, &b = component.ends[1].position;
    PcfPoint centre;
    if (component.centre)
      centre = *component.centre;
    else { // at the foot of the branch's perpendicular
      const Vector3 way = b - a;
      const double part =
          way.norm() > 0. ? (component.branches[0].position - a) * way / way.norm_square() : 0.;
      centre.position = a + std::min(1., std::max(0., part)) * way;
      centre.line = component.line;
      notes.assumed.push_back({component.line, component.keyword +
                                                   " has no CENTRE-POINT: taken where its branch "
                                                   "is square to its run, at " +
                                                   text_of_place(on_grid(centre.position))});
    }
    if (!rigid && is_off_line(centre.position, a, b, std::max(tolerance, 0.01 * a.distance(b))))
      file.fail(component.line,
                component.keyword + " whose CENTRE-POINT " + text_of_place(centre.position) +
                    " is not between its END-POINTs",
                "a centre on the line from END-POINT to END-POINT", "the right CENTRE-POINT");
    const unsigned int from = node(component.ends[0], component), middle = node(centre, component),
                       to = node(component.ends[1], component);
    if (from == middle || middle == to)
      fail_length(component, std::min(a.distance(centre.position), centre.position.distance(b)));
    Piece first = piece_of(i, from, middle), second = piece_of(i, middle, to);
    second.run = first.run;
    if (component.bore(0) != component.bore(1))
      second.section = sections.section(component, component.bore(1), true);
    first.rigid = second.rigid = rigid;
    network.pieces.push_back(first);
    network.pieces.push_back(second);
    for (const PcfPoint &end : component.branches)
      add_branch(i, middle, end, rigid);
  }

  void add_branch(const std::size_t i, const unsigned int foot, const PcfPoint &end,
                  const bool rigid) {
    const PcfComponent &component = line.components[i];
    const unsigned int to = node(end, component);
    if (to == foot)
      fail_length(component, points.points[foot].distance(end.position));
    Piece branch;
    branch.component = i;
    branch.from = foot;
    branch.to = to;
    branch.rigid = rigid;
    branch.material = sections.material(component);
    const double bore = end.bore > 0. ? end.bore : component.bore(0);
    branch.section = sections.section(component, bore, bore != component.bore(0));
    branch.run = ++n_runs;
    network.pieces.push_back(branch);
    if (!rigid)
      network.branches.push_back({foot, branch.run, i});
  }

  /// A branch on the line: of an OLET, of a bend that has one.
  void add_olet(const std::size_t i) {
    const PcfComponent &component = line.components[i];
    const Point3 &wanted = component.centre->position;
    const PlaceOnPieces places(network, tolerance);
    std::optional<PlaceOnPieces::Place> place = places.nearest(wanted);
    if (place && place->distance > tolerance)
      if (const auto on_bend = foot_on_bend(places, component))
        place = on_bend;
    if (!place || place->distance > tolerance)
      file.fail(
          component.line,
          component.keyword + " whose CENTRE-POINT " + text_of_place(wanted) + " is on no pipe" +
              (place ? ": the nearest is " + rounded_number(1e3 * place->distance) + " mm away"
                     : ""),
          "a centre on the axis of a pipe, or a branch whose axis goes through that of a "
          "bend, within the tolerance of " +
              rounded_number(1e3 * tolerance) + " mm",
          "the right CENTRE-POINT, or a larger --tolerance");
    const unsigned int foot = node_at(*place);
    for (const PcfPoint &end : component.branches) {
      if (!component.ends.empty()) {
        add_branch(i, foot, end, false);
        network.nodes = points.points;
        continue;
      }
      // A branch alone has no ends: its bores are those of the branch.
      if (end.bore == 0.)
        file.fail(end.line, "BRANCH1-POINT without a bore", "x y z bore",
                  "the branch's bore behind its co-ordinates");
      Piece branch;
      branch.component = i;
      branch.from = foot;
      branch.to = node(end, component);
      network.nodes = points.points;
      if (branch.to == foot)
        fail_length(component, 0.);
      branch.material = sections.material(component);
      branch.section = sections.section(component, end.bore);
      branch.run = ++n_runs;
      network.pieces.push_back(branch);
      network.branches.push_back({foot, branch.run, i});
    }
  }

  /// Where the axis of a branch, from CENTRE-POINT to BRANCH1-POINT, goes through that of a bend
  /// whose tangents meet at CENTRE-POINT.
  std::optional<PlaceOnPieces::Place> foot_on_bend(const PlaceOnPieces &places,
                                                   const PcfComponent &component) const {
    const Point3 &corner = component.centre->position;
    const Vector3 way = component.branches[0].position - corner;
    for (std::size_t i = 0; i < network.pieces.size(); ++i) {
      const Piece &bend = network.pieces[i];
      if (bend.radius == 0. || bend.corner->distance(corner) > tolerance)
        continue;
      const auto at = [&](const double part) { return places.on(i, Point3(corner + part * way)); };
      // The distance falls and rises once: the arc lies on one side of its tangents.
      double low = -bend.radius / way.norm(), high = 1.;
      for (unsigned int k = 0; k < 100; ++k) {
        const double one = low + (high - low) / 3., other = high - (high - low) / 3.;
        if (at(one).distance < at(other).distance)
          high = other;
        else
          low = one;
      }
      return at((low + high) / 2.);
    }
    return {};
  }

  /// The node at a place; a piece is cut in two for it.
  unsigned int node_at(const PlaceOnPieces::Place &place) {
    if (place.node)
      return *place.node;
    const unsigned int number = points.insert(on_grid(place.position));
    network.nodes = points.points;
    Piece &piece = network.pieces[place.piece];
    if (number == piece.from || number == piece.to)
      return number;
    Piece rest = piece;
    if (piece.radius > 0.)
      std::tie(piece, rest) = cut_bend(piece, network.nodes[piece.from], network.nodes[number],
                                       network.nodes[piece.to]);
    piece.to = rest.from = number;
    network.pieces.push_back(rest);
    return number;
  }

  void place(const std::size_t i) {
    const PcfComponent &component = line.components[i];
    const PcfPoint &point = component.place ? *component.place : component.ends[0];
    const PlaceOnPieces places(network, tolerance);
    const std::optional<PlaceOnPieces::Place> place = places.nearest(point.position);
    const double reach =
        place ? std::max(tolerance, places.reach(place->piece, sections)) : tolerance;
    if (!place || place->distance > reach) {
      notes.not_understood.push_back(
          {component.line,
           component.keyword + " " + component.name + " at " + text_of_place(point.position) +
               " stands on no pipe" +
               (place ? ": the nearest is " + rounded_number(1e3 * place->distance) + " mm away"
                      : "") +
               "; left out"});
      return;
    }
    if (place->distance > std::max(tolerance, least_to_say))
      notes.moved.push_back({point.line, component.keyword + " " + component.name + ": moved by " +
                                             rounded_number(1e3 * place->distance) +
                                             " mm onto the axis, to " +
                                             text_of_place(place->position)});
    Placed placed{i, {}, place->piece, place->position, place->in_the_middle};
    if (place->node || network.pieces[place->piece].radius == 0.)
      placed.node = node_at(*place);
    (component.shape == Shape::support ? network.supports : network.joints).push_back(placed);
  }

  /// The same pipe twice would be twice as stiff.
  void check_doubles() const {
    std::multimap<std::pair<unsigned int, unsigned int>, const Piece *> known;
    const auto lies_on = [&](const Piece &one, const Piece &other) {
      return one.corner.has_value() == other.corner.has_value() &&
             (!one.corner || one.corner->distance(*other.corner) <= tolerance);
    };
    for (const Piece &piece : network.pieces) {
      const std::pair<unsigned int, unsigned int> ends = std::minmax(piece.from, piece.to);
      const auto range = known.equal_range(ends);
      for (auto other = range.first; other != range.second; ++other)
        if (lies_on(piece, *other->second)) {
          const PcfComponent &one = line.components[piece.component];
          file.fail(one.line,
                    one.keyword + " from " + text_of_place(network.nodes[piece.from]) + " to " +
                        text_of_place(network.nodes[piece.to]) + ", where " +
                        line.components[other->second->component].text() + " lies already",
                    "each component once", "removing one of the two");
        }
      known.emplace(ends, &piece);
    }
  }

  const PcfFile &file;
  const PcfLine &line;
  const double tolerance;
  SectionPlanner &sections;
  Notes &notes;
  PointSet points;
  Network network;
  std::vector<std::size_t> olets;
  unsigned int n_runs = 0;
};

} // namespace

Network make_pieces(const PcfFile &file, const PcfLine &line, const double tolerance,
                    SectionPlanner &sections, Notes &notes) {
  return PieceMaker(file, line, tolerance, sections, notes).make();
}

} // namespace frictionbeam::import
