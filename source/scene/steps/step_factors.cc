// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/steps/step_factors.h"

namespace frictionbeam {

std::vector<double> declared_factors(const Scene &scene, const LoadStep &step) {
  std::vector<double> factors;
  for (const Load &load : scene.loads)
    factors.push_back(load.kind == Load::Kind::preload ? 1. : 0.);
  for (const auto &[load, factor] : step.loads)
    factors[load] += factor;
  return factors;
}

} // namespace frictionbeam
