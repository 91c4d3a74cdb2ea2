// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/accuracy_control.h"
#include "analysis/refinement/wall_errors.h"

namespace frictionbeam {

/// Solves a scene as a solid wall, on a mesh with layers cut in two, and says what that leaves.
using SolveWall = std::function<Results(const Scene &, WallMesh &)>;

/**
 * Solve a solid wall to the scene's Accuracy, from a coarse mesh of degree 3 on, with as many
 * increments as beams need (solve_to_accuracy()), of which half are tried on that mesh; again and
 * again, layers are cut in two that hold most of what is left along the pipes, and cells around
 * become more, each unless the other is nearly all that is left (WallErrors), until the quantities'
 * changes from mesh to mesh (accuracy::Convergence) say that they are known, or Solid/Most unknowns
 * is reached.
 * @throws UserError if the scene names no quantities that count
 */
SolvedScene refine_walls(const RunOptions &options, const Scene &scene, const ReadScene &read,
                         const SolveScene &solve_line, const SolveWall &solve);

} // namespace frictionbeam
