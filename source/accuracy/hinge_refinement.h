// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/accuracy_control.h"

namespace frictionbeam {

/**
 * Solve a line again and again, each time with the cells halved whose sections have yielded, until
 * no quantity changes by more than what is demanded: the scene's Accuracy, or 1e-3. Cells grow from
 * the hinges on as they were halved, and those that stay elastic are those of the first mesh. What
 * the last halving changed is the estimate of the error that it leaves: a bound where halving
 * takes half of it or more. The cost counts all runs.
 * @throws UserError if the scene names no quantities
 */
Results refine_hinges(Scene scene, const SolveScene &solve);

} // namespace frictionbeam
