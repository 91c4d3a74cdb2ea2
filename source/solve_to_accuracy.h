// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "run_case.h"

#include <frictionbeam/law_library.h>
#include <frictionbeam/results/results.h>

#include <functional>

namespace frictionbeam {

/**
 * Solve a scene to its Accuracy, as cheaply as the estimates allow.
 *
 * One thing after the other is made finer (accuracy::refinables()): the coarsest three levels are
 * solved, or two that hardly differ; from the differences d of their quantities comes the order p,
 * within bounds, and the error of the finest, d/(2^p - 1); the level that is fine enough by that,
 * with a margin, is gone to straight away and checked by its difference to the one before. The last
 * one's finest run is the answer. Its cost counts all runs.
 *
 * @param scene as read; replaced by the one that was solved last
 * @param solve solves a scene and returns what came out
 */
Results solve_to_accuracy(const RunOptions &options, LawLibrary &laws, Scene &scene,
                          const std::function<Results(Scene &)> &solve);

} // namespace frictionbeam
