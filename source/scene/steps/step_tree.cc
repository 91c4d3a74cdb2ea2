// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/steps/step_tree.h"

#include <cmath>

namespace frictionbeam {

std::optional<unsigned int> step_before(const Scene &scene, const unsigned int step) {
  if (scene.steps[step].from)
    return scene.steps[step].from;
  return step > 0 ? std::optional<unsigned int>(step - 1) : std::nullopt;
}

bool is_branch(const Scene &scene, const unsigned int step) {
  return step > 0 && step_before(scene, step) != step - 1;
}

bool is_returned_to(const Scene &scene, const unsigned int step) {
  for (unsigned int later = step + 2; later < scene.steps.size(); ++later)
    if (scene.steps[later].from == step)
      return true;
  return false;
}

namespace {
/// Whether each number of a combination is one of those of its cases.
bool picks(const Combination::Kind kind) {
  return kind == Combination::Kind::envelope || kind == Combination::Kind::maximum ||
         kind == Combination::Kind::minimum;
}

/// Whether each number of a combination is a size, to which the sign of a factor means nothing.
bool is_size(const Combination::Kind kind) {
  return kind == Combination::Kind::srss || kind == Combination::Kind::absolute;
}

/// How many states of the line a case is; 0 of a difference, or of what a spectrum does.
double states_in(const Scene &scene, const std::string &name, unsigned int &n_steps) {
  for (const LoadStep &step : scene.steps)
    if (step.name == name) {
      ++n_steps;
      return 1.;
    }
  for (const Combination &combination : scene.combinations) {
    if (combination.name != name)
      continue;
    double sum = 0., last = 0.;
    for (const auto &[part, factor] : combination.cases) {
      last = factor * states_in(scene, part, n_steps);
      sum += is_size(combination.kind) ? std::abs(last) : last;
    }
    return combination.kind == Combination::Kind::range ? 0. : picks(combination.kind) ? last : sum;
  }
  return 0.;
}
} // namespace

bool is_state(const Scene &scene, const std::string &name) {
  unsigned int n_steps = 0;
  const double n_states = states_in(scene, name, n_steps);
  return n_states > 0.5 && n_states < 1.5;
}

bool is_judged(const Scene &scene, const std::string &name) {
  for (const Combination &combination : scene.combinations)
    if (combination.name == name &&
        (combination.kind == Combination::Kind::range || picks(combination.kind)))
      return false;
  unsigned int n_steps = 0;
  const double n_states = states_in(scene, name, n_steps);
  return n_steps == 0 || (n_states > 0.5 && n_states < 1.5);
}

} // namespace frictionbeam
