// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program.h"

#include "command/line/run_line.h"
#include "command/size_hangers.h"

#include "base/interruption.h"
#include "base/user_error.h"
#include "results/file/checkpoint.h"
#include "scene/read_scene.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace oracle {

unsigned int Outcome::halvings() const {
  unsigned int sum = 0;
  for (const frictionbeam::StepReport &step : results.steps)
    sum += step.halvings;
  return sum;
}

bool Outcome::several_equilibria() const {
  for (const frictionbeam::StepReport &step : results.steps)
    if (!step.several_equilibria.empty() || !step.undetermined_forces.empty())
      return true;
  return false;
}

namespace {

Outcome run(frictionbeam::LawLibrary &laws, const std::string &file, const std::string &folder,
            const bool resume) {
  Outcome outcome;
  try {
    outcome.scene = frictionbeam::read_scene(file, {}, laws);
    outcome.scene.output.directory = folder;
    outcome.scene.output.resume = resume;
    outcome.scene = frictionbeam::with_sized_hangers(outcome.scene, laws);
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

} // namespace

Outcome run_program(frictionbeam::LawLibrary &laws, const std::string &file,
                    const std::string &folder) {
  return run(laws, file, folder, false);
}

Outcome run_interrupted(frictionbeam::LawLibrary &laws, const std::string &file,
                        const std::string &folder, const int times) {
  frictionbeam::Checkpoint::remove(folder);
  for (int i = 0; i < times; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      alarm(60);
      frictionbeam::interruption::listen();
      raise(SIGTERM);
      try {
        run(laws, file, folder, i > 0);
      } catch (const frictionbeam::Interrupted &) {
        _exit(2);
      } catch (const std::exception &) {
        _exit(1);
      }
      _exit(0); // it came to its end: what is left of it is of no use
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) == 1)
      throw std::runtime_error("a run that was resumed died");
    if (WEXITSTATUS(status) == 0)
      break;
  }
  const Outcome outcome = run(laws, file, folder, true);
  frictionbeam::Checkpoint::remove(folder);
  return outcome;
}

} // namespace oracle
