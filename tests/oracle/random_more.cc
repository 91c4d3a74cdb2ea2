// SPDX-License-Identifier: LGPL-2.1-or-later
#include "generator.h"
#include "path.h"

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {

bool is_pair(const Support &support) {
  return support.kind == "guide" || support.kind == "line stop" || support.kind == "stop";
}

bool has_bends(const Pipe &pipe) {
  return std::any_of(pipe.route.begin(), pipe.route.end(),
                     [](const Corner &corner) { return corner.bend > 0.; });
}

} // namespace

Kinds kinds_of(const std::string &family, Random &random) {
  Kinds kinds;
  kinds.contacts = random.chance(family == "response" ? 0.5 : 0.7);
  kinds.more = family == "more" || (!family.empty() && random.chance(0.3) && family != "large");
  kinds.transient = family == "moving" || (family == "large" && random.chance(0.4));
  kinds.moving = family == "moving";
  kinds.large = family == "large";
  kinds.response = family == "response" || (family == "moving" && random.chance(0.3));
  if (family == "yielding") {
    kinds.yielding = true;
    kinds.transient = random.chance(0.35);
    kinds.moving = kinds.transient && random.chance(0.5);
    kinds.large = random.chance(0.3);
    kinds.response = random.chance(0.1);
  }
  return kinds;
}

void Generator::extras() {
  random = Random(seed * 2654435761u + 17u);
  if (kinds.elastic)
    for (Support &support : scene.supports)
      if (!support.holds_exactly()) {
        if (support.axial_rigidity == 0.)
          support.axial_rigidity = std::pow(10., random.number(5., 9.));
        if (support.shear_rigidity == 0.)
          support.shear_rigidity = std::pow(10., random.number(5., 9.));
      }
  if (kinds.more)
    more();
  if (kinds.moving)
    moving();
  if (kinds.large)
    large();
  if (kinds.response)
    response();
  if (kinds.yielding) {
    allow_laws(scene);
    give_laws(scene, random, true);
  }
}

void Generator::more() {
  double end = 0.;
  for (Step &step : scene.steps)
    if (!step.transient) {
      if (random.chance(0.4))
        step.duration = random.number(0.1, 10.);
      end += step.duration;
    }
  if (random.chance(0.3))
    figures_instead_of_diameters();
  for (Support &support : scene.supports) {
    const bool one = !support.holds_exactly() && support.at.size() == 1 && !is_pair(support);
    if (one && support.kind != "rod" && support.normal_force == 0. && random.chance(0.35))
      ground_on_pipe(support);
    else if (one && support.kind != "rod" && !kinds.transient && random.chance(0.15))
      ground_motion(support, 0., end);
    if (one && support.friction > 0. && !kinds.large && random.chance(0.3)) {
      support.torsional_rigidity = std::pow(10., random.number(2., 6.));
      support.patch_radius = random.chance(0.3) ? 0. : random.number(0.02, 0.2);
    }
    if (one && support.kind != "rod" && random.chance(0.2)) {
      const std::vector<std::pair<std::string, double>> pads = {
          {"steel", 0.3}, {"ptfe", 0.1}, {"graphite", 0.15}, {"concrete", 0.5}, {"roller", 0.03}};
      std::tie(support.pad, support.friction) = random.pick(pads);
    }
  }
  if (kinds.contacts && random.chance(0.35))
    bed();
  if (random.chance(0.25))
    size_a_hanger();
  if (random.chance(0.4))
    histories(end);
  // Of all points are those of the mesh, also within bends that wind has cut: not there.
  if (random.chance(0.2) && std::none_of(scene.pipes.begin(), scene.pipes.end(), &has_bends))
    scene.free_motions[random.whole(0, 5)] = false;
}

/// Area and moments of inertia, where nothing that acts on the pipe needs its diameter.
void Generator::figures_instead_of_diameters() {
  for (const Load &load : scene.loads)
    if (load.kind == "pressure" || load.kind == "wind")
      return;
  for (const Tee &tee : scene.tees)
    if (tee.code)
      return;
  for (std::size_t i = 0; i < scene.sections.size(); ++i) {
    bool bent = false;
    for (const Pipe &pipe : scene.pipes)
      bent = bent || (has_bends(pipe) && (pipe.section == static_cast<int>(i) ||
                                          pipe.end_section == static_cast<int>(i)));
    if (bent || random.chance(0.5))
      continue;
    Section &s = scene.sections[i];
    s.size = s.schedule = "";
    s.diameter = s.wall = s.contents = s.insulation = s.insulation_density = 0.;
    s.area = random.number(1e-3, 2e-2);
    s.inertia = s.area * random.number(1e-3, 3e-2);
    s.torsion = random.chance(0.5) ? 0. : s.inertia * random.number(0.5, 3.);
    if (s.shear == Section::Shear::cowper)
      s.shear = Section::Shear::half;
  }
}

/// The support stands on a point of the line, or on one that springs carry.
void Generator::ground_on_pipe(Support &support) {
  Vec on = Vec::Zero();
  std::map<std::string, Vec> all;
  for (const Pipe &pipe : scene.pipes) {
    const Path path(pipe);
    for (const auto &[name, s] : path.names)
      all[name] = path.at(s);
  }
  for (const Point &point : scene.points)
    all[point.name] = point.position;
  on = all.at(support.at.front());
  const double length = support.length;
  support.own_normal = random.chance(0.6);
  if (random.chance(0.3)) {
    Point post{new_name("post"), on - length * support.normal.normalized()};
    if (random.chance(0.5))
      post.position += 0.05 * random.direction();
    Spring spring;
    spring.name = new_name("spring");
    spring.at = post.name;
    for (int c = 0; c < 3; ++c)
      spring.stiffness[c] = std::pow(10., random.number(5., 9.));
    scene.points.push_back(post);
    scene.springs.push_back(spring);
    support.ground = post.name;
    return;
  }
  std::vector<std::string> others;
  for (const auto &[name, position] : all)
    if ((position - on).norm() > 0.05)
      others.push_back(name);
  support.ground = random.pick(others);
}

/// Elastic all along a pipe, so that it may overlap with other supports.
void Generator::bed() {
  const Pipe &pipe = random.pick(scene.pipes);
  Support bed;
  bed.name = new_name("bed");
  bed.kind = random.chance(0.6) ? "rest" : "friction";
  bed.pipe = pipe.name;
  bed.continuous = true;
  if (bed.kind == "friction")
    bed.normal = random.direction();
  bed.axial_rigidity = std::pow(10., random.number(4., 8.));
  bed.shear_rigidity = std::pow(10., random.number(4., 8.));
  bed.friction = random.chance(0.2) ? 0. : random.number(0.02, 0.4);
  bed.length = random.chance(0.5) ? 1. : random.number(0.1, 2.);
  if (random.chance(0.3))
    bed.normal_force = random.number(10., 5000.);
  else if (random.chance(0.2))
    bed.gap = random.number(1e-4, 1e-2);
  std::vector<std::string> names;
  for (const auto &[name, s] : Path(pipe).names)
    names.push_back(name);
  if (names.size() > 1 && random.chance(0.4)) {
    bed.from = names[random.whole(0, names.size() - 2)];
    bed.to = names.back();
  }
  Random cells(seed + 1983); // without cells, a hundred of them: dense, that takes seconds
  if (scene.cell_length == 0. && cells.chance(0.9))
    scene.cell_length = cells.number(0.7, 3.);
  scene.supports.push_back(bed);
}

void Generator::size_a_hanger() {
  if (scene.hangers.empty()) {
    const std::string at = free_point();
    if (at.empty())
      return;
    scene.hangers.emplace_back();
    scene.hangers.back().name = new_name("hanger");
    scene.hangers.back().at = at;
    scene.hangers.back().constant = random.chance(0.3);
  }
  Hanger &hanger = scene.hangers.front();
  hanger.stiffness = hanger.cold_load = 0.;
  hanger.variation = random.number(0.05, 0.4);
  std::vector<std::string> steps; // static ones
  for (const Step &step : scene.steps)
    if (!step.transient)
      steps.push_back(step.name);
  if (random.chance(0.4))
    hanger.weight_step = random.pick(steps);
  if (random.chance(0.4))
    hanger.hot_step = random.pick(steps);
}

/// Tables of loads that begin with the run.
void Generator::histories(const double end) {
  for (std::size_t l = 1; l < scene.loads.size(); ++l) {
    if (random.chance(0.5))
      continue;
    Load &load = scene.loads[l];
    load.run_time = random.chance(0.4);
    double t = 0.;
    for (int i = 0, n = random.whole(1, 4); i <= n; ++i) {
      load.history.push_back({t, random.number(-0.5, 1.5)});
      t += end / n * random.number(0.3, 1.2);
    }
  }
}

/// From rest at @p from: a table of positions.
void Generator::ground_motion(Support &support, const double from, const double end) {
  double t = 0.;
  Vec x = Vec::Zero();
  for (int i = 0, n = random.whole(1, 3); i <= n; ++i) {
    support.ground_motion.push_back({from + t, x[0], x[1], x[2]});
    t += (end - from) / n * random.number(0.3, 1.2);
    x += (kinds.transient ? 1e-4 : 3e-3) * random.vector(0., 1.);
  }
}

} // namespace oracle
