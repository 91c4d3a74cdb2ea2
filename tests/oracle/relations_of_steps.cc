// SPDX-License-Identifier: LGPL-2.1-or-later
#include "relations.h"

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {

bool any_history(const Scene &scene) {
  return std::any_of(scene.loads.begin(), scene.loads.end(),
                     [](const Load &load) { return !load.history.empty(); }) ||
         std::any_of(scene.supports.begin(), scene.supports.end(),
                     [](const Support &support) { return !support.ground_motion.empty(); });
}

bool creeps(const Scene &scene) {
  for (const Section &section : scene.sections)
    for (const LawValue &of : section.law_values)
      if (of.name == "Creep coefficient" || of.name == "Primary creep coefficient")
        return true;
  return false;
}

double factor_of(const Step &step, const int load) {
  double sum = 0.;
  for (const auto &[l, factor] : step.loads)
    if (l == load)
      sum += factor;
  return sum;
}

/// Every step with itself, but for one more behind @p after.
void pair_steps(const Scene &scene, const std::size_t after, Mapping &mapping) {
  for (std::size_t s = 0; s < scene.steps.size(); ++s)
    mapping.steps.emplace_back(s, s < after ? s : s + 1);
}

double time_step(const Scene &scene) {
  for (const auto &[entry, value] : scene.more)
    if (entry == "Time/Step")
      return std::stod(value);
  return 0.;
}

/// Whether a transient step begins with another acceleration in Newmark's formulas than the one
/// that the step before has come to: those of generalized_alpha belong to another instant than the
/// motion, and start as the true ones.
bool begins_with_another_acceleration(const Scene &scene) {
  return std::any_of(scene.more.begin(), scene.more.end(), [](const auto &entry) {
    return entry.first == "Time/Integrator" && entry.second == "generalized_alpha";
  });
}

} // namespace

/// A static step between two of its increments; a transient one at the end of its ramp, or between
/// two time steps.
std::optional<Related> step_split(const Scene &scene, Random &random) {
  if (scene.modes > 0 || scene.quantities || any_history(scene))
    return {};
  for (const Hanger &hanger : scene.hangers)
    if (hanger.cold_load == 0.)
      return {}; // which is sized for a step
  std::vector<std::size_t> candidates;
  const std::size_t first_candidate = // hangers come with the first static step as a whole
      !scene.hangers.empty() && !scene.steps[0].transient ? 1 : 0;
  for (std::size_t s = first_candidate; s < scene.steps.size(); ++s)
    if (scene.steps[s].transient ? !begins_with_another_acceleration(scene)
                                 : scene.steps[s].increments > 1)
      candidates.push_back(s);
  if (candidates.empty())
    return {};
  const std::size_t which = random.pick(candidates);
  Related related{scene, {}};
  Step first = scene.steps[which], second = first;
  first.name += "a";
  double part = 1.; // of the way from the loads before to those after
  if (!first.transient) {
    first.increments = random.whole(1, second.increments - 1);
    part = static_cast<double>(first.increments) / second.increments;
    second.increments -= first.increments;
    first.duration = part * second.duration;
  } else if (first.ramp > 0. && first.ramp < 0.99 * first.duration) {
    first.duration = first.ramp;
  } else if (first.ramp == 0.) {
    const int n = std::ceil(first.duration / time_step(scene) - 1e-9);
    if (n < 2)
      return {};
    first.duration *= static_cast<double>(random.whole(1, n - 1)) / n;
  } else
    return {};
  second.duration -= first.duration;
  second.ramp = 0.;
  if (part < 1.) {
    first.loads.clear();
    for (int l = 0; l < static_cast<int>(scene.loads.size()); ++l) {
      const double before = which == 0 ? 0. : factor_of(scene.steps[which - 1], l),
                   factor = before + part * (factor_of(second, l) - before);
      if (factor != 0.)
        first.loads.emplace_back(l, factor);
    }
  }
  related.scene.steps[which] = second;
  related.scene.steps.insert(related.scene.steps.begin() + which, first);
  pair_steps(scene, which, related.mapping);
  return related;
}

/// Between two steps a third, whatever it does, from whose beginning the second starts.
std::optional<Related> detour(const Scene &scene, Random &random) {
  if (scene.quantities || scene.steps.size() < 2) // which look at all steps
    return {};
  for (const Hanger &hanger : scene.hangers)
    if (hanger.cold_load == 0. && (hanger.weight_step.empty() || hanger.hot_step.empty()))
      return {}; // which is sized for the first and the second
  Related related{scene, {}};
  const std::size_t next = random.whole(1, static_cast<int>(scene.steps.size()) - 1);
  Step away = scene.steps[random.chance(0.5) ? next : next - 1];
  away.name += "d";
  away.duration *= random.number(0.5, 1.5);
  away.ramp = std::min(away.ramp, away.duration);
  const double factor = random.number(-0.5, 0.9);
  for (auto &load : away.loads)
    load.second *= factor;
  related.scene.steps[next].from = scene.steps[next - 1].name;
  related.scene.steps.insert(related.scene.steps.begin() + next, away);
  pair_steps(scene, next, related.mapping);
  return related;
}

/// Where nothing changes, nothing moves.
std::optional<Related> last_step_again(const Scene &scene, Random &random) {
  if (scene.modes > 0 || scene.quantities || any_history(scene) || scene.steps.back().transient ||
      creeps(scene))
    return {};
  Related related{scene, {}};
  Step again = scene.steps.back();
  again.name += "b";
  again.increments = random.whole(1, 3);
  related.scene.steps.push_back(again);
  pair_steps(scene, scene.steps.size(), related.mapping);
  related.mapping.steps.emplace_back(scene.steps.size() - 1, scene.steps.size());
  return related;
}

/// By little, so that what has yielded only springs back.
void unload(Scene &scene) {
  Step last = scene.steps.back();
  last.name += "u";
  last.increments = 1;
  for (auto &load : last.loads)
    load.second *= 0.97;
  scene.steps.push_back(last);
}

std::optional<Related> in_ten_increments(const Scene &scene, Random &) {
  if (scene.modes > 0 || scene.quantities || any_history(scene) || scene.has_contacts() ||
      creeps(scene))
    return {};
  Related related{scene, {}};
  related.scene.steps.back().increments = 10;
  return related;
}

void make_static(Scene &scene) {
  for (Material &material : scene.materials)
    material.density = std::max(material.density, 1000.);
  for (Pipe &pipe : scene.pipes)
    if (pipe.mass >= 0.)
      pipe.mass = std::max(pipe.mass, 100.);
}

/// Static steps against transient ones that take a day each. With backward differences (theta = 1)
/// and as many time steps as increments, what is left of inertia is 1/(omega h)^2; a hundred steps
/// behind let it decay.
std::optional<Related> slowly(const Scene &scene, Random &) {
  if (scene.modes > 0 || scene.quantities || any_history(scene))
    return {};
  for (const Support &support : scene.supports)
    if (support.continuous && support.normal_force > 0.)
      return {};
  constexpr double h = 1e4;
  Related related{scene, {}};
  for (Step &step : related.scene.steps) {
    step.transient = true;
    step.ramp = h * step.increments;
    step.duration = step.ramp + 20. * h;
  }
  related.scene.more.emplace_back("Time/Integrator", "moreau_jean");
  related.scene.more.emplace_back("Time/Step", "1e4");
  related.scene.more.emplace_back("Time/Theta", "1");
  return related;
}

std::optional<Related> interrupted(const Scene &scene, Random &) { return Related{scene, {}}; }

void make_small_displacements(Scene &scene) {
  constexpr double factor = 1e-6; // of rounding and of the square of motions, both are small
  for (Step &step : scene.steps)
    for (auto &load : step.loads)
      load.second *= factor;
  scene.hangers.clear();
  for (Section &section : scene.sections)
    for (LawValue &of :
         section.law_values) // strains of the metal are as small as those of the line
      if (of.name == "Yield stress" || of.name.rfind("Hardening", 0) == 0)
        of.value *= factor;
  for (Support &support : scene.supports) {
    support.normal_force = 0.;
    support.gap *= factor;
  }
}

std::optional<Related> linear_kinematics(const Scene &scene, Random &) {
  if (!scene.large_displacements)
    return {};
  Related related{scene, {}};
  related.scene.large_displacements = false;
  for (Load &load : related.scene.loads)
    load.follow = false;
  return related;
}

} // namespace oracle
