// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include "scene/scene.h"
#include <frictionbeam/law_library.h>

namespace frictionbeam {

/// Solve the scene's pipes as a solid wall, and write everything but summary and report into its
/// folder. By all processes.
Results run_solid(const Scene &scene, const LawLibrary &laws);

} // namespace frictionbeam
