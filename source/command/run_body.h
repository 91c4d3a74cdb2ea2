// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include <frictionbeam/law_library.h>

namespace frictionbeam {

/// Solve the scene's continuum on meshes refined until its quantities are known to the tolerance,
/// and write everything but summary and report into its output folder. Called by all processes.
/// Between increments it writes checkpoints. @throws Interrupted if a signal asked for it
Results run_continuum(const Scene &scene, const LawLibrary &laws);

} // namespace frictionbeam
