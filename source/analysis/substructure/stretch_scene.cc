// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/substructure/wall_stretch.h"

#include "mesh/solid/patch_layout.h"
#include "model/line/point_loads.h"
#include "scene/support_pair.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// The route of a part of a path.
std::vector<RoutePoint> route_of(const PipePath &path, const SolidStretch &stretch) {
  const double tolerance = 1e-9 * path.length();
  std::vector<RoutePoint> route = {{"", path.point(stretch.from), 0.}};
  for (const PipePath::Segment &segment : path.segments()) {
    const double end = segment.start + segment.length;
    if (end <= stretch.from + tolerance || segment.start >= stretch.to - tolerance)
      continue;
    if (segment.radius > 0.) {
      const double leg = segment.radius * std::tan(segment.length / segment.radius / 2.);
      route.push_back({"", segment.begin + leg * segment.first_tangent, segment.radius});
    } else if (end < stretch.to - tolerance && &segment != &path.segments().back() &&
               (&segment + 1)->radius == 0.)
      route.push_back({"", segment.end, 0.});
  }
  route.push_back({"", path.point(stretch.to), 0.});
  return route;
}

/// In lengths r sqrt(r/t): a bend hardly feels how a rest beyond presses the wall oval.
constexpr double felt_from = 4.;

bool pushes_from_one_side(const FrictionSupport &support) {
  return support.law == "coulomb" && !is_of_a_pair(support.kind) && support.kind != "rod" &&
         support.kind != "snubber" && support.ground.empty() && support.normal_force == 0. &&
         !support.placement.continuous;
}

/// From where to where a path is straight about one of its places; empty in a bend.
std::array<double, 2> run_at(const PipePath &path, const double s) {
  double begin = 0., end = path.length();
  for (const PipePath::Segment &segment : path.segments())
    if (segment.radius > 0.) {
      const double segment_end = segment.start + segment.length;
      if (segment.start < s && segment_end > s)
        return {{s, s}};
      if (segment_end <= s)
        begin = segment_end;
      else
        end = std::min(end, segment.start);
    }
  return {{begin, end}};
}

/// A load as it acts on the metal of a stretch.
Load on_metal(Load load, const std::string &pipe) {
  load.at.clear(); // what acts on points acts on the line
  if (load.kind == Load::Kind::pressure && !load.is_on(pipe))
    load.value = 0.;
  return load;
}

} // namespace

StretchScene::StretchScene(const Scene &whole, const LineMesh &of, const SolidStretch &stretch)
    : scene(whole) {
  const Pipe &pipe = whole.pipes[stretch.pipe];
  const PipePath path(pipe, whole.units);
  Pipe part = pipe;
  part.route = route_of(path, stretch);
  scene.pipes = {part};
  scene.loads.clear();
  for (const Load &load : whole.loads)
    scene.loads.push_back(on_metal(load, pipe.name));
  scene.supports.clear();
  scene.restraints.clear();
  scene.points.clear();

  const MeshedPipe &meshed = of.pipes[stretch.pipe];
  const double tolerance = 1e-4 * whole.sections[pipe.section].outer_radius;
  MeshedPipe chain;
  for (unsigned int i = 0; i < meshed.s.size(); ++i) {
    if (meshed.s[i] < stretch.from - tolerance || meshed.s[i] > stretch.to + tolerance)
      continue;
    if (vertices.empty())
      first_cell = i;
    else
      chain.bend_radius.push_back(meshed.bend_radius[i - 1]);
    chain.vertices.push_back(vertices.size());
    chain.s.push_back(std::clamp(meshed.s[i], stretch.from, stretch.to) - stretch.from);
    line.points["v" + std::to_string(vertices.size())] = vertices.size();
    line.vertices.push_back(of.vertices[meshed.vertices[i]]);
    vertices.push_back(meshed.vertices[i]);
  }
  line.pipes = {chain};
  for (const Load &load : whole.loads) {
    at_sections.push_back(std::vector<Motion>(vertices.size(), Motion{}));
    for (const auto &[vertex, force] : point_loads(whole, of, load))
      if (const auto at = std::find(vertices.begin(), vertices.end(), vertex); at != vertices.end())
        at_sections.back()[at - vertices.begin()] = force;
  }
  add_rests(whole, of, stretch);
}

void StretchScene::add_rests(const Scene &whole, const LineMesh &of, const SolidStretch &stretch) {
  const PipePath path(scene.pipes.front(), scene.units);
  const Section &section = scene.sections[scene.pipes.front().section];
  const MeshedPipe &meshed = of.pipes[stretch.pipe];
  const double length = section.decay_length(), end = path.length(), outer = section.outer_radius;
  const std::array<double, 2> room = {
      {stretch.anchored[0] ? 2. * outer : 0., end - (stretch.anchored[1] ? 2. * outer : 0.)}};
  // Where neither an anchor nor another bend ends it.
  const double tangent = (1. - 1e-9) * scene.solid.reach * length;
  const std::array<bool, 2> is_cut = {
      {!stretch.anchored[0] && run_at(path, 0.)[1] >= tangent,
       !stretch.anchored[1] && end - run_at(path, end)[0] >= tangent}};
  std::vector<std::array<double, 2>> taken;
  for (unsigned int i = 0; i < whole.supports.size(); ++i) {
    const FrictionSupport &support = whole.supports[i];
    if (!pushes_from_one_side(support))
      continue;
    const double half = (support.width > 0. ? support.width : 2. * outer) / 2.;
    for (unsigned int k = 0; k < of.supports[i].size(); ++k) {
      Site site = of.supports[i][k];
      if (site.arm.norm() > 0.) // on edges, outside
        continue;
      const auto at = std::find(meshed.vertices.begin(), meshed.vertices.end(), site.vertex);
      if (at == meshed.vertices.end() ||
          std::abs(push_of(support, site.tangent) * site.tangent) > square_enough)
        continue;
      const double s = meshed.s[at - meshed.vertices.begin()] - stretch.from;
      const std::array<double, 2> patch = {{s - half, s + half}}, run = run_at(path, s);
      const std::string name =
          support.name + (n_places(of.supports[i]) > 1 ? "." + std::to_string(site.place + 1) : "");
      const double outside = std::max(is_cut[0] ? -patch[0] : 0., is_cut[1] ? patch[1] - end : 0.);
      if (outside > 0. && scene.solid.reach * length + outside < felt_from * length + 2. * half) {
        near_rests.push_back(name);
        wanted_reach = std::max(wanted_reach, scene.solid.reach + outside / length);
      }
      if (patch[0] < std::max(room[0], run[0]) || patch[1] > std::min(room[1], run[1]) ||
          std::any_of(taken.begin(), taken.end(), [&](const std::array<double, 2> &other) {
            return patch[0] < other[1] && patch[1] > other[0];
          }))
        continue;
      taken.push_back(patch);
      site.vertex = site.at =
          std::find(vertices.begin(), vertices.end(), site.vertex) - vertices.begin();
      site.place = 0;
      scene.supports.push_back(support);
      scene.supports.back().name = name;
      line.supports.push_back({site});
    }
  }
}

} // namespace frictionbeam
