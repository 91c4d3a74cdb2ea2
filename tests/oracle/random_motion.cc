// SPDX-License-Identifier: LGPL-2.1-or-later
#include "generator.h"
#include "write_scene.h"

#include <algorithm>
#include <cmath>

namespace oracle {

void Generator::moving() {
  Step &shake = scene.steps.back();
  std::string integrator;
  for (const auto &[entry, value] : scene.more)
    if (entry == "Time/Integrator")
      integrator = value;
  const bool rigid = integrator == "moreau_jean" || integrator == "nonsmooth_alpha";
  double before = 0.;
  for (const Step &step : scene.steps)
    before += &step == &shake ? 0. : step.duration;
  bool moves = false; // a ground
  for (Support &support : scene.supports) {
    if (support.holds_exactly())
      continue;
    if (support.friction > 0. && random.chance(0.4)) {
      support.pad = "";
      support.dynamic_friction = support.friction * random.number(0.2, 1.);
    }
    if (rigid && support.normal_force == 0. && support.axial_rigidity == 0. && random.chance(0.2))
      support.restitution = random.number(0., 1.);
    if (support.ground.empty() && support.kind != "rod" && support.at.size() == 1 &&
        random.chance(0.2)) {
      support.ground_run_time = random.chance(0.5);
      ground_motion(support, 0., shake.duration);
      if (support.ground_run_time)
        for (auto &row : support.ground_motion)
          row[0] += before;
      moves = true;
    }
  }
  special_law();
  if (random.chance(0.5))
    snubber();
  for (Spring &spring : scene.springs)
    for (double &damping : spring.damping)
      if (random.chance(0.2))
        damping = std::pow(10., random.number(1., 4.));
  for (const auto &[load, factor] : shake.loads)
    if (scene.loads[load].history.empty() && random.chance(0.4)) {
      double t = 0.;
      for (int i = 0, n = random.whole(1, 4); i <= n; ++i) {
        scene.loads[load].history.push_back({t, random.number(-0.5, 1.5)});
        t += shake.duration / n * random.number(0.3, 1.2);
      }
    }
  if (random.chance(0.4))
    scene.settings.push_back({"Time/Mass damping", random.number(0., 20.), 0, -1});
  if (random.chance(0.3))
    scene.settings.push_back({"Time/Stiffness damping", random.number(0., 1e-4), 0, 1});
  if (random.chance(0.15))
    scene.settings.push_back({"Time/Modal damping", random.number(0., 0.1)});
  if (integrator == "moreau_jean" && random.chance(0.3))
    scene.settings.push_back({"Time/Theta", random.number(0.5, 1.)});
  if (integrator == "generalized_alpha" && random.chance(0.5))
    scene.settings.push_back({"Time/Spectral radius", random.number(0., 1.)});
  if (random.chance(0.3)) {
    Initial initial;
    if (random.chance(0.4))
      initial.pipes = {random.pick(scene.pipes).name};
    else
      initial.at = {random.pick(candidates)};
    if (random.chance(0.4))
      initial.about = random.pick(candidates);
    for (int c = 0; c < 3; ++c)
      initial.velocity[c] = random.number(-0.2, 0.2);
    if (random.chance(0.4))
      for (int c = 3; c < 6; ++c)
        initial.velocity[c] = random.number(-5., 5.);
    scene.initial.push_back(initial);
  }
  if (random.chance(0.3)) { // the motion goes on in a second step
    Step second = shake;
    second.name = new_name("step");
    second.ramp = random.chance(0.5) ? 0. : second.duration * random.number(0.3, 1.);
    if (!second.loads.empty() && random.chance(0.5))
      second.loads.pop_back();
    scene.steps.push_back(second);
  }
  if (random.chance(0.15)) { // without statics before
    scene.steps.erase(scene.steps.begin(),
                      std::find_if(scene.steps.begin(), scene.steps.end(),
                                   [](const Step &step) { return step.transient; }));
    for (Support &support : scene.supports)
      if (support.ground_run_time)
        for (auto &row : support.ground_motion)
          row[0] -= before;
    if (scene.initial.size() == 1)
      scene.initial.front().displacement = {1e-4, -2e-4, 1e-4, 0., 0., 0.};
  }
  if (random.chance(0.3))
    scene.settings.push_back({"Time/Output interval", 0.004, 0, 1});
  if (random.chance(0.2))
    scene.more.emplace_back("Output/Every increment", "true");
  if (integrator == "newmark" && random.chance(0.4)) {
    scene.settings.push_back({"Time/Gamma", random.number(0.5, 0.8)});
    scene.settings.push_back({"Time/Beta", random.number(0.42, 0.5)});
  }
  if (!moves && random.chance(0.2)) { // and then stops
    Step rest;
    rest.name = new_name("step");
    rest.loads = scene.steps.front().loads;
    rest.increments = random.whole(1, 3);
    scene.steps.push_back(rest);
  }
}

/// A law without a threshold in closed form.
void Generator::special_law() {
  if (!random.chance(0.25))
    return;
  const std::string at = free_point();
  if (at.empty())
    return;
  Support support;
  support.name = new_name("pad");
  support.kind = "friction";
  support.at = {at};
  support.normal = random.chance(0.5) ? Vec(0., 0., 1.) : random.direction();
  support.law = random.chance(0.5) ? "skeleton" : "whip_restraint";
  support.length = random.number(0.2, 2.);
  if (support.law == "skeleton") {
    support.axial_rigidity = std::pow(10., random.number(5., 9.));
    support.drag = std::pow(10., random.number(1., 4.));
  } else {
    support.gap = random.chance(0.5) ? 0. : random.number(1e-4, 1e-2);
    support.whip.stiffness = std::pow(10., random.number(6., 9.));
    support.whip.coefficient = std::pow(10., random.number(3., 6.));
    support.whip.exponent = random.number(0.1, 0.6);
  }
  scene.supports.push_back(support);
}

void Generator::snubber() {
  const std::string at = free_point();
  if (at.empty())
    return;
  Support support;
  support.name = new_name("snubber");
  support.kind = "snubber";
  support.at = {at};
  support.normal = random.direction();
  support.snubber.stiffness = std::pow(10., random.number(5., 9.));
  support.snubber.velocity = random.chance(0.3) ? 0. : std::pow(10., random.number(-3., 0.));
  support.snubber.acceleration = random.chance(0.5) ? 0. : std::pow(10., random.number(-1., 2.));
  support.snubber.dead_band = random.chance(0.5) ? 0. : random.number(1e-5, 1e-3);
  support.snubber.drag = random.chance(0.5) ? 0. : std::pow(10., random.number(1., 4.));
  scene.supports.push_back(support);
}

/// What Kinematics = corotational allows, with loads that bend the pipes far.
void Generator::large() {
  scene.large_displacements = true;
  scene.arcs = false;
  scene.modes = 0;
  for (Support &support : scene.supports)
    support.rotations = Support::Rotations::none;
  for (Spring &spring : scene.springs)
    for (int c = 3; c < 6; ++c)
      spring.stiffness[c] = spring.damping[c] = 0.;
  for (Load &load : scene.loads) {
    for (auto &given : load.given)
      for (int c = 3; c < 6; ++c)
        given[c] = given[c] && !kinds.transient;
    if (load.kind == "force") {
      load.follow = random.chance(0.4);
      for (auto &at : load.at)
        for (double &component : at.second)
          component *= 5.;
    }
  }
  for (Step &step : scene.steps)
    step.increments *= random.whole(2, 4);
  for (auto &[entry, value] : scene.more)
    if (entry == "Time/Integrator")
      value = "moreau_jean";
}

void Generator::response() {
  if (!kinds.transient) {
    scene.modes = random.whole(2, 8);
    scene.lumped = random.chance(0.2);
    for (int i = 0, n = random.whole(1, 2); i < n; ++i) {
      Spectrum spectrum;
      spectrum.name = new_name("quake");
      double f = random.number(0.2, 2.);
      for (int k = 0, points = random.whole(2, 4); k < points; ++k, f *= random.number(1.5, 8.))
        spectrum.curve.push_back({f, random.number(0.5, 20.)});
      for (int d = 0; d < 3; ++d)
        if (d == 0 || random.chance(0.6))
          spectrum.directions[d] = random.chance(0.5) ? 1. : random.number(0.2, 1.);
      scene.spectra.push_back(spectrum);
    }
    std::vector<std::string> anchors;
    for (const Support &support : scene.supports)
      if (support.kind == "anchor")
        anchors.push_back(support.name);
    if (anchors.size() > 1 && random.chance(0.4)) // supports that move apart
      scene.spectra.back().supports = {random.pick(anchors)};
    scene.more.emplace_back("Response/Modes",
                            random.pick(std::vector<std::string>{"srss", "cqc", "absolute"}));
    scene.more.emplace_back("Response/Directions", random.chance(0.5) ? "srss" : "absolute");
    scene.more.emplace_back("Response/Groups", random.chance(0.5) ? "srss" : "absolute");
    scene.more.emplace_back("Response/Interpolation", random.chance(0.5) ? "log-log" : "linear");
    if (random.chance(0.5))
      scene.more.emplace_back("Response/Damping", "0.02");
    if (random.chance(0.4))
      scene.more.emplace_back("Response/Missing mass", "true");
    if (random.chance(0.3))
      scene.more.emplace_back("Modes/Step", random.pick(scene.steps).name);
    if (random.chance(0.2)) { // frequencies alone
      scene.spectra.clear();
      if (random.chance(0.5))
        scene.more.emplace_back("Modes/Friction", random.chance(0.7) ? "off" : "as in the step");
    }
  }
  judged();
}

/// Combinations, stresses by the code, nozzles.
void Generator::judged() {
  scene.quantities = true;
  scene.monitors.resize(std::min<std::size_t>(scene.monitors.size(), 4));
  for (int i = 0, n = random.whole(0, 3); i < n; ++i) {
    const std::vector<std::string> known = cases_of(scene);
    Combination combination;
    combination.name = new_name("sum");
    combination.kind = random.pick(
        std::vector<std::string>{"sum", "range", "envelope", "srss", "absolute", "sum"});
    for (const std::string &name : known)
      if (combination.cases.empty() || random.chance(0.5))
        combination.cases.emplace_back(name, random.chance(0.5) ? 1. : random.number(-1.5, 1.5));
    scene.combinations.push_back(combination);
  }
  for (const Support &support : scene.supports)
    if ((support.kind == "anchor" || support.kind == "restraint") && support.at.size() == 1 &&
        support.pipe.empty() && random.chance(0.5)) {
      Nozzle nozzle;
      nozzle.support = support.name;
      for (int c = 0; c < 6; ++c)
        nozzle.allowed[c] = random.chance(0.2) ? 0. : std::pow(10., random.number(2., 5.));
      scene.nozzles.push_back(nozzle);
    }
  const bool by_figures = std::any_of(scene.sections.begin(), scene.sections.end(),
                                      [](const Section &s) { return s.area > 0.; });
  if (by_figures || random.chance(0.2))
    return;
  for (Tee &tee : scene.tees) {
    tee.kind =
        random.pick(std::vector<std::string>{"welding tee", "reinforced", "unreinforced",
                                             "extruded", "welded-in", "integrally reinforced"});
    if (tee.kind == "reinforced")
      tee.pad = random.number(0.002, 0.02);
    if (tee.kind == "extruded" || tee.kind == "welding tee")
      tee.crotch_radius = random.number(0.005, 0.05);
  }
  for (Material &material : scene.materials) {
    if (random.chance(0.3)) {
      material.table.clear();
      material.grade = random.chance(0.5) ? "carbon steel" : "austenitic steel";
      material.modulus_temperature = random.number(0., 300.);
    }
    material.allowable_cold = random.number(8e7, 1.4e8);
    material.allowable_hot = random.number(6e7, 1.3e8);
  }
  for (Section &section : scene.sections)
    if (section.size.empty() && random.chance(0.4))
      section.corrosion = section.wall * random.number(0., 0.3);
  scene.more.emplace_back("Stress/Code", "B31.3");
  const std::vector<std::string> known = cases_of(scene);
  scene.more.emplace_back("Stress/Sustained", scene.steps.front().name);
  if (random.chance(0.5))
    scene.more.emplace_back("Stress/Occasional", random.pick(known));
  if (scene.steps.size() > 1)
    scene.more.emplace_back("Stress/Expansion", scene.steps[0].name + " to " + scene.steps[1].name);
  if (random.chance(0.3))
    scene.more.emplace_back("Stress/Liberal", "true");
  if (random.chance(0.3))
    scene.more.emplace_back("Stress/Cycles factor", "0.9");
  if (random.chance(0.3))
    scene.more.emplace_back("Stress/Occasional factor", "1.2");
}

} // namespace oracle
