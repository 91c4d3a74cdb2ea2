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

bool is_difference(const Scene &scene, const std::string &name) {
  for (const Combination &combination : scene.combinations) {
    if (combination.name != name)
      continue;
    double sum = 0.;
    bool any_step = false;
    for (const auto &[part, factor] : combination.cases)
      for (const LoadStep &step : scene.steps)
        if (step.name == part) {
          sum += factor;
          any_step = true;
        }
    constexpr double nothing = 1e-9;
    return combination.kind == Combination::Kind::range ||
           (combination.kind == Combination::Kind::sum && any_step && std::abs(sum) < nothing);
  }
  return false;
}

} // namespace frictionbeam
