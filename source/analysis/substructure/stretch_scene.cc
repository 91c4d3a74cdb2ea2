// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/substructure/wall_stretch.h"

#include "base/user_error.h"

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
}

} // namespace frictionbeam
