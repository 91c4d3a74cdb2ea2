// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/steps/step_factors.h"

namespace frictionbeam {

std::vector<double> declared_factors(const LoadStep &step, const std::size_t n_loads) {
  std::vector<double> factors(n_loads, 0.);
  for (const auto &[load, factor] : step.loads)
    factors[load] += factor;
  return factors;
}

} // namespace frictionbeam
