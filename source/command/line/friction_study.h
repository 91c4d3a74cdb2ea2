// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include "scene/scene.h"

#include <frictionbeam/law_library.h>

#include <string>

namespace frictionbeam {

/// Folder of the run with friction times a multiplier, within that of the scene.
std::string study_folder(const std::string &folder, const double multiplier);

/// Solve the scene again for each of its Friction multipliers but 1, each into a folder of its own.
void study_friction(const Scene &scene, const LawLibrary &laws, Results &results);

} // namespace frictionbeam
