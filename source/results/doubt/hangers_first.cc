// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/doubt/hangers_first.h"

#include <algorithm>

namespace frictionbeam {

void remark_on_hangers_first(const Scene &scene, Results &results) {
  constexpr double nothing = 1e-6; // of the energy that is turned over
  if (results.steps.empty() || scene.steps[0].transient ||
      std::none_of(scene.springs.begin(), scene.springs.end(),
                   [](const Spring &spring) { return spring.preload != 0.; }))
    return;
  const StepReport &first = results.steps[0];
  if (first.increments < 2 ||
      first.energy.dissipated + first.energy.inelastic <= nothing * first.energy.turnover)
    return;
  results.remarks.push_back("Step " + scene.steps[0].name +
                            ": hangers pull with their whole cold load from the first of " +
                            std::to_string(first.increments) +
                            " increments on, while the weight grows with them, and what has "
                            "slipped or yielded on that way "
                            "keeps a trace of it. With Increments = 1 both come together.");
}

} // namespace frictionbeam
