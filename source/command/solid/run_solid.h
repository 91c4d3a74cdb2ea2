// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/refinement/wall_errors.h"
#include "model/line_model.h"
#include "results/results.h"
#include "scene/scene.h"
#include <frictionbeam/law_library.h>

namespace frictionbeam {

/// Solve the scene's pipes as a solid wall, and write everything but summary and report into its
/// folder. By all processes.
/// @param mesh if given, layers to cut in two, and where errors of what is solved are told
Results run_solid(const Scene &scene, const LawLibrary &laws, WallMesh *const mesh = nullptr);

/// Lay out the wall without solving anything. @throws UserError for what run_solid() would refuse
/// before it solves @return how large the wall is, in words
std::string check_solid(const Scene &scene, const Model &line);

} // namespace frictionbeam
