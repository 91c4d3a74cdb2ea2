// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include <frictionbeam/law_library.h>

namespace frictionbeam {

/**
 * Mesh, model, load sequence, modes, spectra, combinations and stresses of a scene. Rows of csv and
 * vtu files are written into Scene::output.directory, which exists, while it runs; summary and
 * report are left to the caller.
 */
Results solve_scene(const Scene &scene, const LawLibrary &laws);

} // namespace frictionbeam
