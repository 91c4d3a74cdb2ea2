// SPDX-License-Identifier: LGPL-2.1-or-later
#include "random_scene.h"

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {

using Unit = LawValue::Unit;

bool any_history(const Scene &scene) {
  return std::any_of(scene.loads.begin(), scene.loads.end(),
                     [](const Load &load) { return !load.history.empty(); }) ||
         std::any_of(scene.supports.begin(), scene.supports.end(),
                     [](const Support &support) { return !support.ground_motion.empty(); });
}

/// Draws the parameters of one section's law.
class Metal {
public:
  Metal(Section &section, Random &random) : section(section), random(random) {}

  void add(const std::string &name, const double value, const Unit unit = Unit::none) {
    section.law_values.push_back({unit, name, value});
  }
  double power_of_ten(const double low, const double high) {
    return std::pow(10., random.number(low, high));
  }

  /// Yield stress and hardening, some of it so weak that limit loads are near.
  void yields() {
    const double yield = power_of_ten(7.3, 8.8);
    add("Yield stress", yield, Unit::pascal);
    const int how = random.whole(0, 4);
    if (how == 0 || how == 2)
      add("Isotropic modulus", power_of_ten(8.5, 10.3), Unit::pascal);
    if (how == 1 || how == 2)
      add("Kinematic modulus", power_of_ten(8.5, 10.3), Unit::pascal);
    if (how == 3) {
      double strain = 0., stress = yield;
      for (int i = 1, n = random.whole(1, 6); i <= n; ++i) {
        strain += power_of_ten(-4., -2.);
        stress *= random.number(1., 1.5);
        add("Hardening strain " + std::to_string(i), strain);
        add("Hardening stress " + std::to_string(i), stress, Unit::pascal);
      }
    }
    if (!random.chance(0.3))
      return;
    double temperature = random.number(-50., 50.), modulus = 1., strength = 1.;
    for (int i = 1, n = random.whole(1, 4); i <= n; ++i) {
      add("Temperature " + std::to_string(i), temperature, Unit::degree);
      add("Modulus factor " + std::to_string(i), modulus);
      add("Yield factor " + std::to_string(i), strength);
      temperature += random.number(50., 200.);
      modulus *= random.number(0.7, 1.);
      strength *= random.number(0.5, 1.);
    }
  }

  /// Strains at 1e8 Pa of 1e-9 to 1e-5 in a second.
  void creeps() {
    const double stress = 1e8;
    if (random.chance(0.8)) {
      const double n = random.number(1., 6.);
      add("Creep exponent", n);
      add("Creep coefficient", power_of_ten(-10., -6.) / std::pow(stress, n));
    }
    if (random.chance(0.5)) {
      const double k = random.number(1., 5.), m = random.number(0.2, 1.), hour = 3600.;
      add("Primary creep exponent", k);
      add("Primary time exponent", m);
      add("Primary creep coefficient",
          power_of_ten(-5., -3.) / std::pow(stress, k) / std::pow(hour, m));
      add("Primary hardening", random.whole(0, 1));
    }
    if (random.chance(0.5)) {
      add("Creep activation temperature", random.number(1e3, 4e4));
      add("Creep reference temperature", random.number(100., 500.), Unit::degree);
    }
  }

private:
  Section &section;
  Random &random;
};

bool has_bends(const Pipe &pipe) {
  return std::any_of(pipe.route.begin(), pipe.route.end(),
                     [](const Corner &corner) { return corner.bend > 0.; });
}

} // namespace

void allow_laws(Scene &scene) {
  scene.joints.clear();
  for (Tee &tee : scene.tees) { // whose springs are joints
    tee.code = false;
    tee.in_plane = tee.out_of_plane = 0.;
  }
  for (Initial &initial : scene.initial)
    initial.displacement = {};
  auto &settings = scene.settings;
  settings.erase(std::remove_if(settings.begin(), settings.end(),
                                [&](const Setting &setting) {
                                  return setting.entry == "Time/Theta" ||
                                         (setting.entry == "Time/Modal damping" &&
                                          !scene.large_displacements);
                                }),
                 settings.end());
}

void give_laws(Scene &scene, Random &random, const bool yield) {
  const bool is_static = std::none_of(scene.steps.begin(), scene.steps.end(),
                                      [](const Step &step) { return step.transient; });
  const bool may_creep = is_static && yield && !any_history(scene);
  const bool has_reducers = std::any_of(scene.pipes.begin(), scene.pipes.end(),
                                        [](const Pipe &pipe) { return pipe.end_section >= 0; });
  bool creeps = false;
  for (std::size_t i = 0; i < scene.sections.size(); ++i) {
    Section &section = scene.sections[i];
    std::vector<Pipe *> pipes;
    for (Pipe &pipe : scene.pipes)
      if (pipe.section == static_cast<int>(i) && has_bends(pipe))
        pipes.push_back(&pipe);
    if (random.chance(yield ? 0.15 : 0.))
      continue;
    Metal metal(section, random);
    if (section.area > 0.) {
      if (!yield || !pipes.empty()) // a rectangle is not as stiff about both axes
        continue;
      section.law = "fibre_rectangle";
      section.shear = Section::Shear::none;
      metal.add("Fibres along the height", 8.);
      metal.add("Fibres along the width", 8.);
      metal.yields();
      continue;
    }
    const bool flexible = std::any_of(pipes.begin(), pipes.end(), [](const Pipe *pipe) {
      return pipe->flexibility != Pipe::Flexibility::none;
    });
    section.law = (!yield && flexible) || has_reducers || random.chance(0.5) ? "global_plastic"
                                                                             : "fibre_pipe";
    const bool fibres = section.law == "fibre_pipe";
    if (fibres) {
      for (Pipe *const pipe : pipes) // it knows nothing of flexible bends
        pipe->flexibility = Pipe::Flexibility::none;
      metal.add("Fibres", random.chance(0.5) ? 15. : 31.);
      metal.add("Radii", random.whole(1, 2));
    }
    if (yield)
      metal.yields();
    else
      metal.add("Yield stress", 1e17, Unit::pascal);
    if (!fibres)
      continue;
    if (!yield && random.chance(0.5)) // is asked in each increment, however little
      metal.add("Creep coefficient", 1e-200);
    else if (may_creep && random.chance(0.4)) {
      metal.creeps();
      creeps = true;
    }
  }
  if (has_reducers) // which have one law
    for (Section &section : scene.sections) {
      section.law = scene.sections.front().law;
      section.law_values = scene.sections.front().law_values;
    }
  if (creeps)
    for (Step &step : scene.steps)
      step.duration = std::pow(10., random.number(0., 5.));
}

} // namespace oracle
