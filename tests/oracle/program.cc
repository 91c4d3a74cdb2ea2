// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program.h"

#include "../../source/size_hangers.h"
#include "../../source/solve_scene.h"

#include <frictionbeam/scene/read_scene.h>
#include <frictionbeam/scene/user_error.h>

namespace oracle {

unsigned int Outcome::halvings() const {
  unsigned int sum = 0;
  for (const frictionbeam::StepReport &step : results.steps)
    sum += step.halvings;
  return sum;
}

bool Outcome::several_equilibria() const {
  for (const frictionbeam::StepReport &step : results.steps)
    if (!step.several_equilibria.empty())
      return true;
  return false;
}

Outcome run_program(frictionbeam::LawLibrary &laws, const std::string &file,
                    const std::string &folder) {
  Outcome outcome;
  try {
    outcome.scene = frictionbeam::read_scene(file, {}, laws);
    outcome.scene.output.directory = folder;
    frictionbeam::size_hangers(outcome.scene, laws);
    outcome.results = frictionbeam::solve_scene(outcome.scene, laws);
  } catch (const frictionbeam::UserError &error) {
    outcome.message = error.what();
    return outcome;
  }
  outcome.kind = outcome.results.status == frictionbeam::RunStatus::converged
                     ? Outcome::Kind::converged
                     : Outcome::Kind::stopped;
  return outcome;
}

} // namespace oracle
