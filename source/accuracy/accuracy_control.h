// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/run_options.h"

#include "results/results.h"

#include <functional>

namespace frictionbeam {

struct SolvedScene {
  Scene scene;
  Results results;
};

/// Reads the scene again, with these settings as further options --set.
using ReadScene = std::function<Scene(const std::vector<std::string> &settings)>;
using SolveScene = std::function<Results(const Scene &)>;

/**
 * Solve a scene to its Accuracy, as cheaply as the estimates allow.
 *
 * One thing after the other is made finer (accuracy::refinables()): the coarsest three levels are
 * solved, or two that hardly differ; from the differences of each quantity comes its order, and the
 * error of the finest answer (accuracy::Convergence); the level that is fine enough by that, with a
 * margin, is gone to straight away and checked in the same way. The last one's finest run is the
 * answer. A continuum refines itself (accuracy::continuum_settings()). With Model = auto, the line
 * is solved if what it leaves out is estimated to be small enough (accuracy::line_forms()), else
 * the continuum. The cost counts all runs.
 *
 * @param scene as read
 * @return with the scene that was solved last
 */
SolvedScene solve_to_accuracy(const RunOptions &options, Scene scene, const ReadScene &read,
                              const SolveScene &solve);

} // namespace frictionbeam
