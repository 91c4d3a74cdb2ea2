// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/solid/wall_layout.h"
#include "mesh/solid/patch_layout.h"
#include "mesh/solid/wall_manifold.h"

#include "base/numbers.h"
#include "base/user_error.h"
#include "scene/in_units.h"
#include <frictionbeam/generalized_strain.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double growth = 0.5;     ///< of a straight run's cells, of the distance
constexpr double no_corner = 1e-6; ///< of two tangents

class WallLayout {
public:
  WallLayout(const Scene &scene, const LineMesh &line, const std::vector<double> &halved);
  PipeWall make();

private:
  void chain_pipes();
  /// @throws UserError for a pipe that is hardly there
  void check_length(const unsigned int pipe, const PipePath &path) const;
  void add_segment(const PipePath::Segment &path, const unsigned int pipe);
  /// The edges of patches, 15 degrees on either side of what is mostly an axis of the section, are
  /// those of cells if there are 12, 24, 36 .. around: of 12, 36 .. if these are turned by half a
  /// cell.
  bool needs_turn() const { return !scene.supports.empty() && wall.around % 24 == 12; }
  void place_rings();
  void add_rings_between(const double from, const double to);
  void make_cells();
  void name_faces();

  /// Places where rings have to be, rising, and what stands there.
  struct Place {
    double s;
    std::optional<unsigned int> vertex;
  };
  void ask_for_ring(const double s, const std::optional<unsigned int> vertex = {}) {
    places.push_back({s, vertex});
  }
  /// @throws UserError for two points of one ring
  void check_apart(const Place &a, const Place &b) const;
  /// Length of the cells of a straight run at @p s.
  double cell_length(const double s) const;

  const Scene &scene;
  const LineMesh &line;
  const std::vector<double> &halved; ///< where rings are besides
  PipeWall wall;
  double first = 0., longest = 0.; ///< cells
  std::vector<Place> places;
};

WallLayout::WallLayout(const Scene &scene, const LineMesh &line, const std::vector<double> &halved)
    : scene(scene), line(line), halved(halved) {
  const Section &section = scene.sections[scene.pipes.front().section];
  wall.outer = section.outer_radius;
  wall.inner = section.outer_radius - section.wall;
  wall.around = scene.solid.cells_around;
  wall.through = scene.solid.cells_through;
  first = scene.solid.first_cell > 0. ? scene.solid.first_cell
                                      : std::sqrt(wall.mean_radius() * section.wall);
  longest = scene.solid.longest_cell > 0. ? scene.solid.longest_cell : 4. * wall.outer;
}

void WallLayout::add_segment(const PipePath::Segment &path, const unsigned int pipe) {
  WallSegment segment;
  segment.path = path;
  segment.pipe = pipe;
  segment.start = wall.length();
  if (wall.segments.empty()) {
    const LocalAxes axes(path.first_tangent);
    const double turn = needs_turn() ? numbers::PI / wall.around : 0.;
    segment.a = std::cos(turn) * axes.y + std::sin(turn) * axes.z;
    segment.b = std::cos(turn) * axes.z - std::sin(turn) * axes.y;
  } else {
    const WallSegment &before = wall.segments.back();
    if ((before.path.tangent(before.path.length) - path.first_tangent).norm() > no_corner)
      throw UserError("Pipe " + scene.pipes[pipe].name +
                      ": a solid pipe has a corner without a bend.\n  read:    a route that turns "
                      "sharply at " +
                      in_units(scene.units, path.begin) +
                      "\n  allowed: bends at all corners, 'x y z bend R', and pipes that go on as "
                      "the one before ends\n  try:     a bend there, or Model = line");
    segment.a = before.carried(before.a, before.path.length);
    segment.b = before.carried(before.b, before.path.length);
  }
  wall.segments.push_back(segment);
}

void WallLayout::check_length(const unsigned int pipe, const PipePath &path) const {
  double all = 0.;
  for (const PipePath::Segment &segment : path.segments())
    all += segment.length;
  const double least = 0.01 * wall.outer;
  if (all < least)
    throw UserError("Pipe " + scene.pipes[pipe].name +
                    ": it is too short for a wall.\n  read:    " + in_units(scene.units, all, "m") +
                    " of pipe\n  allowed: " + in_units(scene.units, least, "m") +
                    " or more with Model = solid, a hundredth of the outer radius\n  try:     a "
                    "longer Route, or Model = line");
}

void WallLayout::chain_pipes() {
  std::vector<PipePath> paths;
  for (const Pipe &pipe : scene.pipes)
    paths.emplace_back(pipe, scene.units);
  const unsigned int n = paths.size();
  const auto begin = [&](const unsigned int p) { return paths[p].segments().front().begin; };
  const auto end = [&](const unsigned int p) { return paths[p].segments().back().end; };
  const auto meet = [&](const Point3 &p, const Point3 &q) {
    return p.distance(q) < one_place * wall.outer;
  };
  const auto fail = [&](const unsigned int p, const std::string &what) {
    throw UserError("Pipe " + scene.pipes[p].name + ": " + what +
                    "\n  read:    pipes that are no single chain\n  allowed: with Model = solid, "
                    "pipes of which each begins where another ends, without branches, tees and "
                    "loops\n  try:     one route, routes in one direction, or Model = line");
  };
  for (unsigned int p = 0; p < n; ++p)
    check_length(p, paths[p]);
  std::vector<int> before(n, -1), after(n, -1);
  for (unsigned int p = 0; p < n; ++p)
    for (unsigned int q = 0; q < n; ++q) {
      if (p != q && (meet(begin(p), begin(q)) || meet(end(p), end(q))))
        fail(p, "it meets pipe " + scene.pipes[q].name + " with the same end.");
      if (!meet(end(p), begin(q)))
        continue;
      if (p == q || after[p] >= 0 || before[q] >= 0)
        fail(p, "more than two ends meet at its end, or the route closes.");
      after[p] = q;
      before[q] = p;
    }
  const unsigned int first_pipe = std::find(before.begin(), before.end(), -1) - before.begin();
  if (first_pipe == n)
    fail(0, "the pipes form a loop.");
  wall.pipe_start.assign(n, 0.);
  unsigned int n_passed = 0;
  for (int p = first_pipe; p >= 0; p = after[p], ++n_passed) {
    wall.pipe_start[p] = wall.length();
    for (const PipePath::Segment &path : paths[p].segments())
      add_segment(path, p);
  }
  if (n_passed < n) {
    unsigned int other = 0;
    while (before[other] >= 0 || other == first_pipe)
      ++other;
    fail(other, "it is not joined to pipe " + scene.pipes[first_pipe].name + " end to end.");
  }
}

double WallLayout::cell_length(const double s) const {
  double nearest = longest;
  for (const Place &at : places)
    nearest = std::min(nearest, std::abs(s - at.s));
  return std::min(longest, first + growth * nearest);
}

void WallLayout::add_rings_between(const double from, const double to) {
  const WallSegment &segment = wall.segment_at(0.5 * (from + to));
  const unsigned int number = &segment - wall.segments.data();
  std::vector<double> all = {from};
  if (segment.path.radius > 0.) {
    const double angle = (to - from) / segment.path.radius;
    const int n = std::max(1, static_cast<int>(std::ceil(
                                  angle / (numbers::PI / 2.) * scene.solid.cells_per_bend - 1e-6)));
    for (int i = 1; i < n; ++i)
      all.push_back(from + (to - from) * i / n);
  } else {
    // Equal parts of the integral of one over the wished length.
    constexpr unsigned int n_samples = 400;
    std::vector<double> sum(n_samples + 1, 0.);
    const double step = (to - from) / n_samples;
    for (unsigned int i = 0; i < n_samples; ++i)
      sum[i + 1] = sum[i] + step / cell_length(from + (i + 0.5) * step);
    const int n = std::max(1, static_cast<int>(std::ceil(sum.back() - 1e-6)));
    for (int i = 1; i < n; ++i) {
      const double wanted = sum.back() * i / n;
      const auto above = std::upper_bound(sum.begin(), sum.end(), wanted);
      const unsigned int k = above - sum.begin() - 1;
      all.push_back(from + (k + (wanted - sum[k]) / (sum[k + 1] - sum[k])) * step);
    }
  }
  std::copy_if(halved.begin(), halved.end(), std::back_inserter(all),
               [&](const double s) { return s > from && s < to; });
  std::sort(all.begin(), all.end());
  for (const double s : all) {
    WallRing ring;
    ring.s = s;
    ring.segment = number;
    wall.rings.push_back(ring);
    wall.layer_segment.push_back(number);
  }
}

void WallLayout::check_apart(const Place &a, const Place &b) const {
  if (!a.vertex || *a.vertex == *b.vertex)
    return;
  throw UserError("Two points are too near to each other for a solid pipe.\n  read:    points at " +
                  in_units(scene.units, line.vertices[*a.vertex]) + " and " +
                  in_units(scene.units, line.vertices[*b.vertex]) +
                  "\n  allowed: points that are apart by " +
                  in_units(scene.units, one_place * wall.outer, "m") +
                  " or more\n  try:     one point there, or Model = line");
}

void WallLayout::place_rings() {
  const double length = wall.length();
  for (const WallSegment &segment : wall.segments)
    ask_for_ring(segment.start);
  ask_for_ring(length);
  for (const auto &[name, vertex] : line.points)
    ask_for_ring(wall.s_of(line, vertex), vertex);
  for (const auto &sites : line.restraints)
    for (const Site &site : sites)
      ask_for_ring(wall.s_of(line, site.vertex), site.vertex);
  for (const WallPatch &patch : wall.patches) {
    ask_for_ring(patch.from);
    ask_for_ring(wall.s_of(line, patch.vertex), patch.vertex);
    ask_for_ring(patch.to);
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place &p, const Place &q) { return p.s < q.s; });
  std::vector<Place> merged;
  for (const Place &place : places)
    if (merged.empty() || place.s > merged.back().s + one_place * wall.outer)
      merged.push_back(place);
    else if (place.vertex) {
      check_apart(merged.back(), place);
      merged.back().vertex = place.vertex;
    }
  places = merged;
  places.front().s = 0.;
  places.back().s = length;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const std::size_t at = wall.rings.size();
    add_rings_between(places[i].s, places[i + 1].s);
    wall.rings[at].vertex = places[i].vertex;
  }
  WallRing last;
  last.s = length;
  last.segment = wall.layer_segment.back();
  last.vertex = places.back().vertex;
  wall.rings.push_back(last);
  for (WallRing &ring : wall.rings) {
    const WallSegment &segment = wall.segments[ring.segment];
    const double s = ring.s - segment.start;
    ring.centre = segment.path.point(s);
    ring.tangent = segment.path.tangent(s);
    ring.a = segment.carried(segment.a, s);
    ring.b = segment.carried(segment.b, s);
  }
}

void WallLayout::make_cells() {
  ContinuumMesh<3> &mesh = wall.mesh;
  const unsigned int n = wall.around, m = wall.through;
  const double degree = scene.solid.degree,
               unknowns = 3. * n * degree * (m * degree + 1.) * (wall.n_layers() * degree + 1.);
  if (unknowns > scene.solid.most_unknowns)
    throw UserError("The wall would have " + std::to_string(static_cast<long long>(unknowns)) +
                    " unknowns.\n  read:    " + std::to_string(wall.n_layers()) + " layers of " +
                    std::to_string(n * m) + " cells of degree " +
                    std::to_string(scene.solid.degree) + "\n  allowed: Solid/Most unknowns = " +
                    std::to_string(static_cast<long long>(scene.solid.most_unknowns)) +
                    "\n  try:     fewer Cells around, a Longest cell that is longer, or more of "
                    "Most unknowns");
  for (const WallRing &ring : wall.rings)
    for (unsigned int j = 0; j <= m; ++j)
      for (unsigned int i = 0; i < n; ++i) {
        const double angle = 2. * numbers::PI * i / n,
                     radius = wall.inner + (wall.outer - wall.inner) * j / m;
        mesh.vertices.push_back(ring.centre +
                                radius * (std::cos(angle) * ring.a + std::sin(angle) * ring.b));
      }
  const auto vertex = [&](const unsigned int k, const unsigned int j, const unsigned int i) {
    return (k * (m + 1) + j) * n + i % n;
  };
  for (unsigned int k = 0; k < wall.n_layers(); ++k)
    for (unsigned int j = 0; j < m; ++j)
      for (unsigned int i = 0; i < n; ++i) {
        CellData<3> cell;
        for (unsigned int v = 0; v < 8; ++v)
          cell.vertices[v] = vertex(k + v / 4, j + v % 2, i + v / 2 % 2);
        cell.manifold_id = wall.layer_segment[k];
        cell.material_id = wall.pipe_of_layer(k);
        mesh.cells.push_back(cell);
      }
  mesh.geometry_degree = scene.solid.degree;
  for (const WallSegment &segment : wall.segments)
    mesh.manifolds.push_back(std::make_unique<WallManifold>(segment));
}

void WallLayout::name_faces() {
  ContinuumMesh<3> &mesh = wall.mesh;
  mesh.parts = {"bore", "begin", "end"};
  for (const WallPatch &patch : wall.patches)
    mesh.parts.push_back(patch.part);
  std::vector<int> owner(mesh.cells.size(), -1); // patch on the outside of a cell
  const auto add = [&](const unsigned int cell, const unsigned int face,
                       const types::boundary_id part) {
    ContinuumMesh<3>::Face entry;
    for (unsigned int v = 0; v < 4; ++v)
      entry.vertices.push_back(
          mesh.cells[cell].vertices[GeometryInfo<3>::face_to_cell_vertices(face, v)]);
    std::sort(entry.vertices.begin(), entry.vertices.end());
    entry.part = part;
    mesh.faces.push_back(entry);
  };
  const unsigned int n = wall.around, m = wall.through;
  for (unsigned int k = 0; k < wall.n_layers(); ++k)
    for (unsigned int i = 0; i < n; ++i) {
      const unsigned int inside = k * m * n + i, outside = (k * m + m - 1) * n + i;
      add(inside, 0, 1);
      for (unsigned int j = 0; j < m; ++j) {
        if (k == 0)
          add((k * m + j) * n + i, 4, 2);
        if (k + 1 == wall.n_layers())
          add((k * m + j) * n + i, 5, 3);
      }
      const double middle = 0.5 * (wall.rings[k].s + wall.rings[k + 1].s),
                   angle = 2. * numbers::PI * (i + 0.5) / n;
      const WallRing &ring = wall.rings[k];
      for (unsigned int p = 0; p < wall.patches.size(); ++p) {
        const WallPatch &patch = wall.patches[p];
        if (!patch.covers(middle))
          continue;
        const double cosine = patch.outward * (std::cos(angle) * ring.a + std::sin(angle) * ring.b);
        if (!patch.is_collar &&
            std::acos(std::clamp(cosine, -1., 1.)) > patch_half_arc + numbers::PI / n)
          continue;
        if (owner[outside] >= 0)
          throw UserError(
              "Supports " + scene.supports[wall.patches[owner[outside]].support].name + " and " +
              scene.supports[patch.support].name +
              ": their patches meet.\n  read:    two patches on one face of the wall\n  allowed: "
              "patches of 30 degrees that are apart by a cell\n  try:     smaller Widths, more "
              "Cells around, or a larger distance");
        owner[outside] = p;
        add(outside, 1, 4 + p);
      }
    }
}

PipeWall WallLayout::make() {
  chain_pipes();
  wall.patches = lay_patches(scene, line, wall);
  place_rings();
  make_cells();
  name_faces();
  return std::move(wall);
}

} // namespace

PipeWall build_pipe_wall(const Scene &scene, const LineMesh &line,
                         const std::vector<double> &halved) {
  return WallLayout(scene, line, halved).make();
}

} // namespace frictionbeam
