// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/route_plan.h"
#include "mesh/places_on_pipe.h"
#include "mesh/support/edges_of_patch.h"

#include "base/user_error.h"
#include "scene/bed_cells.h"
#include "scene/in_units.h"
#include "scene/solid/mixed_entries.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double most = 1e7; ///< cells of a piece, supports on a pipe
/// Below this part of the line's extent two places are one.
constexpr double same_on_line = 1e-7;

/// The number of cells, from a quotient of lengths, which nodes of a file miss by some 1e-8.
int whole(const double cells) {
  if (cells > most)
    throw UserError("Mesh: 'Cell length', 'Cells per bend' or 'Refinements' makes more than ten "
                    "million cells of one straight run or bend. Give longer or fewer ones.");
  return std::max(1, static_cast<int>(std::ceil(cells - 1e-6)));
}

double extent(const std::vector<PipePath> &paths) {
  Point3 low = paths.front().point(0.), high = low;
  for (const PipePath &path : paths)
    for (const auto &segment : path.segments())
      for (unsigned int d = 0; d < 3; ++d) {
        low[d] = std::min({low[d], segment.begin[d], segment.end[d]});
        high[d] = std::max({high[d], segment.begin[d], segment.end[d]});
      }
  return (high - low).norm();
}

double named_position(const PipePath &path, const std::string &pipe, const std::string &name,
                      const Scene &scene, const double tolerance) {
  for (const auto &named : path.route_points())
    if (named.name == name)
      return named.s;
  for (const NamedPoint &point : scene.points)
    if (point.name == name) {
      const std::vector<double> places = path.all_places(point.position, tolerance);
      if (!places.empty())
        return places.front();
    }
  throw UserError("The point '" + name + "' is not on pipe '" + pipe +
                  "', where a repeated support is to begin or end. Name a point of that pipe in "
                  "From and To, or leave them out for the whole pipe.");
}

/// Arc lengths at which a pipe must have a vertex.
class Breaks {
public:
  Breaks(const Scene &scene, const std::vector<PipePath> &paths, const PipeJunctions &junctions,
         const std::vector<SolidStretch> &solid, const double tolerance)
      : s(paths.size()), tolerance(tolerance) {
    for (unsigned int p = 0; p < paths.size(); ++p) {
      for (const auto &segment : paths[p].segments())
        s[p].push_back(segment.start);
      s[p].push_back(paths[p].length());
      for (const auto &node : junctions.nodes(p))
        s[p].push_back(node.s);
    }
    for (const FrictionSupport &support : scene.supports) {
      add_repeated(scene, paths, support.placement);
      add_edges(scene, paths, support, solid);
    }
    for (const Restraint &restraint : scene.restraints)
      add_repeated(scene, paths, restraint.placement);
    for (const auto &[pipe, place] : scene.mesh.hinge_nodes)
      s[pipe].push_back(place);
    for (const SolidStretch &stretch : solid)
      s[stretch.pipe].insert(s[stretch.pipe].end(), {stretch.from, stretch.to});
    for (auto &breaks : s) {
      std::sort(breaks.begin(), breaks.end());
      breaks.erase(std::unique(breaks.begin(), breaks.end(),
                               [&](const double a, const double b) { return b - a <= tolerance; }),
                   breaks.end());
    }
  }

  std::vector<std::vector<double>> s;
  const double tolerance; ///< [m]

  /// Longest cell where a bed carries a pipe at this place [m]; 0: none does.
  double bed_cell(const unsigned int pipe, const double at) const {
    double longest = 0.;
    for (const Bed &bed : beds)
      if (bed.pipe == pipe && bed.from < at && at < bed.to)
        longest = longest > 0. ? std::min(longest, bed.cell) : bed.cell;
    return longest;
  }

private:
  struct Bed {
    unsigned int pipe;
    double from, to, cell; ///< [m]
  };
  std::vector<Bed> beds;

  /// From where to where a part is repeated along a pipe.
  std::array<double, 2> ends(const Scene &scene, const PipePath &path,
                             const Placement &placement) const {
    const auto end = [&](const std::string &name, const double otherwise) {
      return name.empty() ? otherwise
                          : named_position(path, placement.pipe, name, scene, tolerance);
    };
    return {{end(placement.from, 0.), end(placement.to, path.length())}};
  }

  std::vector<double> repeated(const Scene &scene, const PipePath &path,
                               const Placement &placement) const {
    std::vector<double> places;
    if (placement.every == 0.)
      return places;
    const auto [from, to] = ends(scene, path, placement);
    if ((to - from) / placement.every > most)
      throw UserError("The distance in 'Every' puts more than ten million supports on pipe " +
                      placement.pipe + ". Give a longer one.");
    for (unsigned int i = 1; from + i * placement.every < to - tolerance; ++i)
      places.push_back(from + i * placement.every);
    return places;
  }

  void add_repeated(const Scene &scene, const std::vector<PipePath> &paths,
                    const Placement &placement) {
    if (placement.pipe.empty())
      return;
    for (unsigned int p = 0; p < paths.size(); ++p) {
      if (scene.pipes[p].name != placement.pipe)
        continue;
      const std::vector<double> places = repeated(scene, paths[p], placement);
      s[p].insert(s[p].end(), places.begin(), places.end());
      const auto [from, to] = ends(scene, paths[p], placement);
      if (placement.continuous && to > from) {
        s[p].insert(s[p].end(), {from, to});
        beds.push_back(
            {p, from, to, bed_cell_length(scene.sections[scene.pipes[p].section], to - from)});
      }
    }
  }

  void add_edges(const Scene &scene, const std::vector<PipePath> &paths,
                 const FrictionSupport &support, const std::vector<SolidStretch> &solid) {
    for (unsigned int p = 0; p < paths.size() && stands_on_edges(scene, support); ++p) {
      std::vector<double> places;
      if (support.placement.pipe == scene.pipes[p].name)
        places = repeated(scene, paths[p], support.placement);
      for (const std::string &point : support.placement.points)
        for (const double at : places_of(scene, paths[p], point, tolerance))
          places.push_back(at);
      const std::vector<double> edges =
          edges_at(scene, support, p, places, paths[p].length(), solid);
      s[p].insert(s[p].end(), edges.begin(), edges.end());
    }
  }
};

/// A piece of a bend of a smaller angle than this [rad] is as well a straight cell, to its
/// square/6: 2e-9, where rounding leaves the arc no more digits.
constexpr double smallest_arc = 1e-4;
/// Each cell feels the wind across its chord: arcs of this angle [rad] miss 1e-4 of it.
constexpr double longest_arc_in_wind = 0.03;

/// @param longest cell of straight runs [m]; 0: no bound
int straight_cells(const MeshSettings &settings, const RoutePiece &piece, const double longest) {
  const double cells = piece.bends() ? settings.cells_per_bend * piece.length() /
                                           piece.segment->radius / (numbers::PI / 2.)
                       : longest > 0. ? piece.length() / longest
                                      : 1.;
  return whole(cells);
}

class Divider {
public:
  Divider(const Scene &scene, const std::vector<SolidStretch> &solid)
      : scene(scene), solid(solid),
        mass_on_chords(scene.kinematics == Kinematics::corotational &&
                       std::any_of(scene.steps.begin(), scene.steps.end(),
                                   [](const LoadStep &step) { return step.transient; })),
        windy(std::any_of(scene.loads.begin(), scene.loads.end(),
                          [](const Load &load) { return load.kind == Load::Kind::wind; })) {}

  std::vector<std::vector<RoutePiece>> pieces(const std::vector<PipePath> &paths,
                                              const Breaks &breaks) const {
    std::vector<std::vector<RoutePiece>> result(paths.size());
    for (unsigned int p = 0; p < paths.size(); ++p) {
      auto segment = paths[p].segments().begin();
      for (unsigned int i = 0; i + 1 < breaks.s[p].size(); ++i) {
        const double begin = breaks.s[p][i], end = breaks.s[p][i + 1];
        while (begin >= segment->start + segment->length - breaks.tolerance &&
               segment + 1 != paths[p].segments().end())
          ++segment;
        RoutePiece piece{&*segment, begin, end, 0};
        if (is_solid(p, 0.5 * (begin + end)))
          take_whole(piece);
        else
          divide(piece, scene.pipes[p].end_section.has_value(),
                 scene.mesh.cell_length > 0. ? scene.mesh.cell_length
                                             : breaks.bed_cell(p, 0.5 * (begin + end)));
        result[p].push_back(piece);
      }
    }
    return result;
  }

private:
  /// @param cell_length of the longest one [m]; 0: no bound
  void divide(RoutePiece &piece, const bool is_reducer, const double cell_length) const {
    const int least = is_reducer ? scene.mesh.cells_of_reducer : 1;
    piece.n_cells = halved(std::max(least, straight_cells(scene.mesh, piece, cell_length)));
    if (!scene.mesh.arcs || !piece.bends())
      return;
    const double radius = piece.segment->radius;
    double longest = cell_length > 0. ? cell_length : piece.length();
    if (windy)
      longest = std::min(longest, longest_arc_in_wind * radius);
    const int n =
        std::max(halved(whole(piece.length() / longest)), mass_on_chords ? piece.n_cells : 1);
    if (piece.length() > n * smallest_arc * radius) {
      piece.n_cells = n;
      piece.is_arc = true;
    }
  }

  int halved(const int n_cells) const { return whole(std::ldexp(n_cells, scene.mesh.refinements)); }
  bool is_solid(const unsigned int pipe, const double s) const {
    return std::any_of(solid.begin(), solid.end(), [&](const SolidStretch &stretch) {
      return stretch.pipe == pipe && stretch.from < s && s < stretch.to;
    });
  }
  /// One cell, whose stiffness is that of a solid: each vertex costs that six solutions.
  static void take_whole(RoutePiece &piece) {
    piece.n_cells = 1;
    piece.is_arc = piece.bends() && piece.length() > smallest_arc * piece.segment->radius;
  }

  const Scene &scene;
  const std::vector<SolidStretch> &solid;
  const bool mass_on_chords; ///< of CorotationalCells
  const bool windy;
};

/// @throws UserError for a pipe all of which is one place
double tolerance_of(const Scene &scene, const std::vector<PipePath> &paths) {
  const double length = extent(paths), tolerance = same_on_line * length;
  for (unsigned int p = 0; p < paths.size(); ++p)
    if (paths[p].length() <= tolerance)
      throw UserError("Pipe " + scene.pipes[p].name + " vanishes beside the others.\n  read:    " +
                      in_units(scene.units, paths[p].length(), "m") + " of pipe in a line of " +
                      in_units(scene.units, length, "m") +
                      "\n  allowed: pipes longer than 1e-7 of the line's extent, below which two "
                      "places are one\n  try:     lengths in the same unit");
  return tolerance;
}

} // namespace

RoutePlan::RoutePlan(const Scene &scene) : RoutePlan(scene, paths_of(scene)) {}

RoutePlan::RoutePlan(const Scene &scene, std::vector<PipePath> paths)
    : axes(std::move(paths)), same(tolerance_of(scene, axes)), meetings(scene, axes, same) {
  std::vector<SolidStretch> solid;
  if (!solid_places(scene).empty())
    solid = solid_stretches(scene, axes);
  all = Divider(scene, solid).pieces(axes, Breaks(scene, axes, meetings, solid, same));
}

} // namespace frictionbeam
