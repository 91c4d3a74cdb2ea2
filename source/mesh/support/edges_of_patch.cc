// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/support/edges_of_patch.h"

#include "base/user_error.h"
#include "mesh/solid/patch_layout.h"
#include "scene/in_units.h"
#include "scene/solid/mixed_entries.h"
#include "scene/support_pair.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double same_on_pipe = 1e-6; ///< of its length

/// A place of a pipe, and how far it goes straight on before it and behind it [m].
struct StraightRun {
  unsigned int pipe;
  double s; ///< along the pipe [m]
  double before, behind;
};

/// How far a pipe goes straight on from one of its vertices.
StraightRun run_at(const LineMesh &mesh, const unsigned int p, const unsigned int place) {
  constexpr double straight = 1. - 1e-10; // cosine
  const MeshedPipe &pipe = mesh.pipes[p];
  const auto goes_on = [&](const unsigned int cell, const Vector3 &tangent) {
    return pipe.bend_radius[cell] == 0. &&
           pipe.tangent(mesh.vertices, cell, false) * tangent > straight;
  };
  const Vector3 tangent = pipe.tangent(mesh.vertices, place > 0 ? place - 1 : 0, place > 0);
  unsigned int first = place, last = place;
  while (first > 0 && goes_on(first - 1, tangent))
    --first;
  while (last + 1 < pipe.vertices.size() && goes_on(last, tangent))
    ++last;
  const double s = pipe.s[place];
  return {p, s, s - pipe.s[first], pipe.s[last] - s};
}

bool reaches_into(const std::vector<SolidStretch> &solid, const unsigned int pipe, const double s,
                  const double half) {
  return std::any_of(solid.begin(), solid.end(), [&](const SolidStretch &stretch) {
    return stretch.pipe == pipe && s + half > stretch.from && s - half < stretch.to;
  });
}

/// Of the pipes through a vertex, that on whose straight run both edges of a support's patch are.
std::optional<StraightRun> run_under_patch(const Scene &scene, const LineMesh &mesh,
                                           const FrictionSupport &support,
                                           const PlacesInPipes &places) {
  for (const auto &[pipe, place] : places) {
    const double half = width_of_patch(scene, support, pipe) / 2.,
                 enough = half - same_on_pipe * mesh.pipes[pipe].s.back();
    if (const StraightRun run = run_at(mesh, pipe, place);
        half > 0. && run.before >= enough && run.behind >= enough)
      return run;
  }
  return {};
}

std::vector<SolidStretch> solid_parts(const Scene &scene) {
  return solid_places(scene).empty() ? std::vector<SolidStretch>()
                                     : solid_stretches(scene, paths_of(scene));
}

/// The vertex of a pipe, which RoutePlan has put there.
unsigned int vertex_at(const MeshedPipe &pipe, const double s) {
  unsigned int at = std::lower_bound(pipe.s.begin(), pipe.s.end(), s) - pipe.s.begin();
  if (at == pipe.s.size() || (at > 0 && s - pipe.s[at - 1] < pipe.s[at] - s))
    --at;
  Assert(std::abs(pipe.s[at] - s) <= same_on_pipe * pipe.s.back(),
         ExcMessage("RoutePlan breaks pipes at the edges of patches"));
  return pipe.vertices[at];
}

[[noreturn]] void refuse(const FrictionSupport &support, const std::string &read,
                         const std::string &allowed, const std::string &advice) {
  throw UserError("Support " + part_name(support) + "/Stands on\n  read:    edges, " + read +
                  "\n  allowed: " + allowed + "\n  try:     " + advice);
}

/// Says why a support has no edges at a place.
[[noreturn]] void refuse_place(const Scene &scene, const LineMesh &mesh,
                               const FrictionSupport &support, const Site &site,
                               const PlacesInPipes &places) {
  const std::string where = " at " + in_units(scene.units, mesh.vertices[site.vertex]);
  if (places.empty())
    refuse(support, "where no pipe is," + where, "a place of a pipe", "Stands on = point");
  const unsigned int pipe = places.front().first;
  const double width = width_of_patch(scene, support, pipe);
  if (width == 0.)
    refuse(support,
           "without a Width, on pipe '" + scene.pipes[pipe].name +
               "', whose section has no diameter",
           "a Width along the pipe", "the Width of the shoe");
  StraightRun longest = run_at(mesh, pipe, places.front().second);
  for (const auto &[other, place] : places)
    if (const StraightRun run = run_at(mesh, other, place);
        std::min(run.before, run.behind) > std::min(longest.before, longest.behind))
      longest = run;
  const double most = 2. * std::min(longest.before, longest.behind);
  const auto length = [&](const double one) { return in_units(scene.units, one, "m"); };
  refuse(support,
         "a patch of Width " + length(width) + where + ", where pipe '" +
             scene.pipes[longest.pipe].name + "' is straight from " + length(longest.before) +
             " before to " + length(longest.behind) + " behind it",
         "a patch whose edges are both on one straight run of one pipe",
         (most > 0.1 * width ? "Width = " + length(most) + " or less, or " : std::string()) +
             "Stands on = point");
}

} // namespace

double width_of_patch(const Scene &scene, const FrictionSupport &support, const unsigned int pipe) {
  return support.width > 0. ? support.width
                            : 2. * scene.sections[scene.pipes[pipe].section].outer_radius;
}

bool stands_on_edges(const Scene &scene, const FrictionSupport &support) {
  return support.on_edges && scene.model != ModelKind::solid;
}

bool have_edges(const Scene &scene, const LineMesh &mesh, const FrictionSupport &support,
                const std::vector<Site> &sites) {
  const std::vector<PlacesInPipes> places = places_in_pipes(mesh);
  const std::vector<SolidStretch> solid = solid_parts(scene);
  return std::all_of(sites.begin(), sites.end(), [&](const Site &site) {
    const auto run = run_under_patch(scene, mesh, support, places[site.at]);
    return run &&
           !reaches_into(solid, run->pipe, run->s, width_of_patch(scene, support, run->pipe) / 2.);
  });
}

std::vector<Site> sites_on_edges(const Scene &scene, LineMesh &mesh, const FrictionSupport &support,
                                 const std::vector<Site> &sites) {
  constexpr double along = 0.7; // part of a normal: a shoe under 45 degrees has no two edges
  std::vector<Site> result;
  const std::vector<SolidStretch> solid = solid_parts(scene);
  std::string on_solid;
  const std::vector<PlacesInPipes> places_of = places_in_pipes(mesh);
  for (const Site &site : sites) {
    const PlacesInPipes &places = places_of[site.vertex];
    const auto run = run_under_patch(scene, mesh, support, places);
    if (!run)
      refuse_place(scene, mesh, support, site, places);
    const MeshedPipe &pipe = mesh.pipes[run->pipe];
    const double half = width_of_patch(scene, support, run->pipe) / 2.;
    if (reaches_into(solid, run->pipe, run->s, half)) {
      on_solid +=
          (on_solid.empty() ? "" : ", ") + in_units(scene.units, mesh.vertices[site.vertex]);
      result.push_back(site);
      continue;
    }
    if (std::abs(push_of(support, site.tangent) * site.tangent) > along)
      refuse(support, "of a support that pushes along its pipe",
             "a Normal across the pipe, whose Width is along it", "Stands on = point");
    for (const double way : {-half, half}) {
      Site edge = site;
      edge.vertex = vertex_at(pipe, run->s + way);
      edge.arm = mesh.vertices[edge.vertex] - mesh.vertices[site.vertex];
      edge.tributary = site.tributary / 2.;
      result.push_back(edge);
    }
  }
  if (!on_solid.empty() && support.normal.sign > 0.)
    mesh.remarks.push_back("Support " + part_name(support) +
                           ": where its patch reaches into a solid part it is pushed as a whole, "
                           "and does not stand on edges: " +
                           on_solid + ".");
  return result;
}

std::vector<double> edges_at(const Scene &scene, const FrictionSupport &support,
                             const unsigned int pipe, const std::vector<double> &places,
                             const double length, const std::vector<SolidStretch> &solid) {
  std::vector<double> edges;
  if (!stands_on_edges(scene, support))
    return edges;
  const double half = width_of_patch(scene, support, pipe) / 2., tolerance = same_on_pipe * length;
  for (const double s : places)
    if (!reaches_into(solid, pipe, s, half) && s - half >= -tolerance &&
        s + half <= length + tolerance)
      for (const double way : {-half, half})
        edges.push_back(std::clamp(s + way, 0., length));
  return edges;
}

} // namespace frictionbeam
