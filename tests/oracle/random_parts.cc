// SPDX-License-Identifier: LGPL-2.1-or-later
#include "generator.h"

#include <algorithm>
#include <cmath>

namespace oracle {

std::string Generator::free_point() {
  std::vector<std::string> left;
  for (const std::string &name : candidates)
    if (taken.count(name) == 0)
      left.push_back(name);
  if (left.empty())
    return "";
  const std::string name = random.pick(left);
  taken.insert(name);
  return name;
}

void Generator::hold_ends() {
  const auto hold = [&](const std::string &name, const bool firmly) {
    Support support;
    support.name = new_name("hold");
    support.kind = "anchor";
    support.at = {name};
    if (!firmly && random.chance(0.3)) {
      support.kind = "restraint";
      for (bool &fixed : support.fixed)
        fixed = random.chance(0.6);
      support.fixed[random.whole(0, 2)] = true;
    }
    taken.insert(name);
    scene.supports.push_back(support);
  };
  hold(scene.pipes.front().route.front().name, true);
  for (const auto &end : ends)
    if (random.chance(0.6) && taken.count(end.first) == 0)
      hold(end.first, false);
}

void Generator::supports() {
  for (int i = 0, n = random.whole(0, 3); i < n; ++i) {
    const std::string at = free_point();
    if (at.empty())
      return;
    Support support;
    support.name = new_name("hold");
    support.at = {at};
    support.kind = random.pick(std::vector<std::string>{"restraint", "guide", "line stop", "stop"});
    for (bool &fixed : support.fixed)
      fixed = random.chance(0.3);
    support.fixed[random.whole(0, 5)] = true;
    if (support.kind == "stop") {
      support.normal = random.chance(0.5) ? random.direction() : Vec(Vec::UnitZ());
      if (random.chance(0.3))
        support.direction = "along";
    }
    scene.supports.push_back(support);
  }
}

void Generator::contacts() {
  const bool all_elastic = random.chance(0.25);
  for (int i = 0, n = random.whole(1, 5); i < n; ++i) {
    const std::string at = free_point();
    if (at.empty())
      return;
    Support support;
    support.name = new_name("rest");
    support.at = {at};
    support.kind = random.pick(std::vector<std::string>{"rest", "rest", "rest", "friction", "rod",
                                                        "guide", "line stop", "stop"});
    if (support.kind == "guide" && vertical.count(at) > 0)
      support.kind = "rest";
    const bool pair =
        support.kind == "guide" || support.kind == "line stop" || support.kind == "stop";
    if (support.kind == "friction" || support.kind == "stop")
      support.normal = random.chance(0.5) ? random.direction() : Vec(0., 0., 1.);
    support.friction = support.kind == "rod" || random.chance(0.15) ? 0. : random.number(0.02, 0.4);
    if (pair || random.chance(0.2))
      support.gap = random.number(1e-4, 1e-2);
    support.length = random.chance(0.5) ? 1. : random.number(0.05, 2.);
    if (all_elastic || random.chance(0.2))
      support.axial_rigidity = std::pow(10., random.number(5., 9.));
    if (all_elastic || random.chance(0.2)) {
      support.shear_rigidity = std::pow(10., random.number(5., 9.));
      if (random.chance(0.4))
        support.ratio = random.number(0.3, 3.);
    }
    using Rotations = Support::Rotations;
    if (random.chance(0.2)) {
      support.rotations = random.chance(0.5) ? Rotations::pipe : Rotations::averaged;
      support.length = random.number(0.05, 0.4);
    }
    if (random.chance(0.1) && !pair && support.kind != "rod" && support.gap == 0.)
      support.normal_force = random.number(100., 50000.);
    scene.supports.push_back(support);
  }
}

/// Rests or guides all along a pipe.
void Generator::repeated() {
  const Pipe &pipe = random.pick(scene.pipes);
  double length = 0.;
  for (std::size_t i = 0; i + 1 < pipe.route.size(); ++i)
    length += (pipe.route[i + 1].position - pipe.route[i].position).norm();
  Support support;
  support.name = new_name("row");
  support.pipe = pipe.name;
  support.every = length * random.number(0.2, 0.45);
  support.kind = kinds.contacts ? "rest" : "restraint";
  support.fixed = {false, false, true, false, false, false};
  support.friction = kinds.contacts ? random.number(0.05, 0.3) : 0.;
  scene.supports.push_back(support);
}

void Generator::components() {
  for (int i = 0, n = random.whole(0, 2); i < n; ++i) {
    const std::string at = free_point();
    if (at.empty())
      break;
    Spring spring;
    spring.name = new_name("spring");
    spring.at = at;
    for (int c = 0; c < 6; ++c)
      if (random.chance(0.5))
        spring.stiffness[c] = std::pow(10., random.number(3., 9.));
    spring.stiffness[random.whole(0, 2)] = 1e6;
    if (random.chance(0.3) && candidates.front() != at)
      spring.to = candidates.front() == at ? "" : random.pick(candidates);
    if (spring.to == at)
      spring.to = "";
    scene.springs.push_back(spring);
  }
  for (int i = 0, n = random.whole(0, 2); i < n; ++i)
    scene.masses.push_back(
        {new_name("valve"), {random.pick(candidates)}, random.number(0., 2000.)});
  if (random.chance(0.3)) {
    const std::string at = free_point();
    if (!at.empty()) {
      Hanger hanger;
      hanger.name = new_name("hanger");
      hanger.at = at;
      hanger.constant = random.chance(0.4);
      hanger.cold_load = random.number(100., 20000.);
      if (!hanger.constant)
        hanger.stiffness = std::pow(10., random.number(3., 6.));
      scene.hangers.push_back(hanger);
    }
  }
  for (int i = 0, n = random.chance(0.4) ? random.whole(1, 2) : 0; i < n; ++i) {
    const Pipe &pipe = random.pick(scene.pipes);
    if (pipe.rigid)
      continue;
    std::vector<std::string> names;
    for (const Corner &corner : pipe.route)
      if (!corner.name.empty())
        names.push_back(corner.name);
    Joint joint{new_name("joint"), random.pick(names), pipe.name};
    joint.axial = random.chance(0.5) ? std::pow(10., random.number(4., 8.)) : 0.;
    joint.lateral = random.chance(0.5) ? std::pow(10., random.number(4., 8.)) : 0.;
    joint.bending = random.chance(0.5) ? std::pow(10., random.number(3., 7.)) : 0.;
    joint.torsion = random.chance(0.5) ? std::pow(10., random.number(3., 7.)) : 0.;
    if (joint.axial > 0. && random.chance(0.5))
      joint.thrust_area = random.number(0.001, 0.2);
    scene.joints.push_back(joint);
  }
}

void Generator::loads() {
  Load weight;
  weight.name = "weight";
  if (random.chance(0.2))
    weight.vector = random.vector(1., 20.);
  scene.loads.push_back(weight);
  const std::vector<std::string> kinds_of_load = {"temperature", "pressure", "force",
                                                  "line force",  "wind",     "displacement",
                                                  "temperature", "force",    "ground acceleration"};
  bool windy = false;
  for (int i = 0, n = random.whole(1, 3); i < n; ++i) {
    Load load;
    load.kind = random.pick(kinds_of_load);
    load.name = new_name("load");
    const bool on_pipes = load.kind == "temperature" || load.kind == "pressure" ||
                          load.kind == "line force" || load.kind == "wind";
    if (on_pipes && random.chance(0.3))
      load.pipes = {random.pick(scene.pipes).name};
    if (load.kind == "temperature")
      load.value = random.number(-100., 450.);
    else if (load.kind == "pressure")
      load.value = random.number(1e4, 2e7);
    else if (load.kind == "line force")
      load.vector = random.vector(1., 2000.);
    else if (load.kind == "ground acceleration")
      load.vector = random.vector(0.1, 5.);
    else if (load.kind == "wind") {
      if (windy)
        continue;
      windy = true;
      load.vector = random.vector(10., 2000.);
      load.value = random.number(0.3, 1.5);
    } else {
      const std::string at = load.kind == "force" ? random.pick(candidates) : free_point();
      if (at.empty())
        continue;
      Six values{};
      std::array<bool, 6> given{};
      for (int c = 0; c < 6; ++c) {
        given[c] = random.chance(0.4) || c == 2;
        values[c] = load.kind == "force" ? random.number(-5000., 5000.)
                                         : random.number(-1., 1.) * (c < 3 ? 0.02 : 0.3);
      }
      load.at.emplace_back(at, values);
      if (load.kind == "displacement")
        load.given.push_back(given);
    }
    scene.loads.push_back(load);
  }
}

void Generator::steps() {
  for (int i = 0, n = random.whole(1, 3); i < n; ++i) {
    Step step;
    step.name = new_name("step");
    for (int l = 0; l < static_cast<int>(scene.loads.size()); ++l)
      if (random.chance(l == 0 ? 0.9 : 0.7) || (i == 0 && l == 1))
        step.loads.emplace_back(l, random.chance(0.6) ? 1. : random.number(-0.5, 1.5));
    if (kinds.contacts)
      step.increments = random.whole(1, 4);
    scene.steps.push_back(step);
  }
  if (!kinds.transient)
    return;
  Step shake; // a force, a weight or a motion that is put on within a few time steps
  shake.name = new_name("step");
  shake.transient = true;
  shake.duration = random.number(0.01, 0.03);
  shake.ramp = random.chance(0.5) ? 0. : shake.duration * random.number(0.3, 1.);
  for (int l = 0; l < static_cast<int>(scene.loads.size()); ++l)
    if (random.chance(0.7))
      shake.loads.emplace_back(l, random.number(-0.5, 1.5));
  scene.steps.push_back(shake);
  std::vector<std::string> integrators = {"moreau_jean", "nonsmooth_alpha"};
  if (std::all_of(scene.supports.begin(), scene.supports.end(), [](const Support &s) {
        return s.holds_exactly() || (s.axial_rigidity > 0. && s.shear_rigidity > 0.);
      })) // others would take a stiffness of their own for rigid contacts
    integrators = {"newmark", "generalized_alpha"};
  scene.more.emplace_back("Time/Integrator", random.pick(integrators));
  scene.more.emplace_back("Time/Step", "1e-3");
}

} // namespace oracle
