// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/solid/solid_files.h"

namespace frictionbeam {

/// Where the equivalent stress of a wall, which is taken for elastic, is the most times the Yield
/// stress of its material, in words; empty: nowhere above it.
/// @param frames whose steps are those of the scene
std::string doubt_of_stresses(const Scene &scene, const PipeWall &wall,
                              const std::vector<WallFrame> &frames);

} // namespace frictionbeam
