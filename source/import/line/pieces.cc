// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/line/pieces.h"

#include "base/number_text.h"
#include "import/line/bend_geometry.h"
#include "import/line/place_on_pieces.h"
#include "mesh/point_set.h"

#include <cmath>

namespace frictionbeam::import {

namespace {

constexpr double grid = 1e9;          ///< of written co-ordinates [1/m]
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
    case Shape::pipe:
    case Shape::bend:
    case Shape::reducer:
      add_run(i);
      return;
    default:
      return; // placed on the line when there is one
    }
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

  void add_olet(const std::size_t i) {
    PcfComponent with_ends = line.components[i];
    const PlaceOnPieces places(network, tolerance);
    const std::optional<PlaceOnPieces::Place> place = places.nearest(with_ends.centre->position);
    if (!place || place->distance > tolerance)
      file.fail(with_ends.line,
                with_ends.keyword + " whose CENTRE-POINT " +
                    text_of_place(with_ends.centre->position) + " is on no pipe" +
                    (place
                         ? ": the nearest is " + rounded_number(1e3 * place->distance) + " mm away"
                         : ""),
                "a centre on the axis of a pipe, within the tolerance of " +
                    rounded_number(1e3 * tolerance) + " mm",
                "the right CENTRE-POINT, or a larger --tolerance");
    if (network.pieces[place->piece].radius > 0. && !place->node)
      file.fail(with_ends.line, with_ends.keyword + " on a bend", "a branch on a straight pipe",
                "a TEE beside the bend");
    const unsigned int foot = node_at(*place);
    // A branch alone has no ends: its bores are those of the branch.
    if (with_ends.branches[0].bore == 0.)
      file.fail(with_ends.branches[0].line, "BRANCH1-POINT without a bore", "x y z bore",
                "the branch's bore behind its co-ordinates");
    Piece branch;
    branch.component = i;
    branch.from = foot;
    branch.to = node(with_ends.branches[0], with_ends);
    network.nodes = points.points;
    if (branch.to == foot)
      fail_length(with_ends, 0.);
    branch.material = sections.material(with_ends);
    branch.section = sections.section(with_ends, with_ends.branches[0].bore);
    branch.run = ++n_runs;
    network.pieces.push_back(branch);
    network.branches.push_back({foot, branch.run, i});
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
    std::map<std::pair<unsigned int, unsigned int>, std::size_t> known;
    for (const Piece &piece : network.pieces) {
      if (piece.corner)
        continue;
      const auto [other, is_new] =
          known.emplace(std::minmax(piece.from, piece.to), piece.component);
      if (is_new)
        continue;
      const PcfComponent &one = line.components[piece.component];
      file.fail(one.line,
                one.keyword + " from " + text_of_place(network.nodes[piece.from]) + " to " +
                    text_of_place(network.nodes[piece.to]) + ", where " +
                    line.components[other->second].text() + " lies already",
                "each component once", "removing one of the two");
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

Point3 on_grid(const Point3 &point) {
  Point3 result;
  for (unsigned int d = 0; d < 3; ++d)
    result[d] = std::round(point[d] * grid) / grid;
  return result;
}

std::vector<std::vector<std::size_t>> Network::pieces_at() const {
  std::vector<std::vector<std::size_t>> result(nodes.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    result[pieces[i].from].push_back(i);
    result[pieces[i].to].push_back(i);
  }
  return result;
}

Network make_pieces(const PcfFile &file, const PcfLine &line, const double tolerance,
                    SectionPlanner &sections, Notes &notes) {
  return PieceMaker(file, line, tolerance, sections, notes).make();
}

} // namespace frictionbeam::import
