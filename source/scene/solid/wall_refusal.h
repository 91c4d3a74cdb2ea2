// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>

namespace frictionbeam {

/// Why the wall of a pipe cannot be a solid.
struct WallRefusal {
  std::string section, entry;      ///< of the parameter file, which says so
  std::string read, allowed, hint; ///< parts of a message
};

/// None if it can. @param bend_radius of its tightest bend that is to be a solid [m]; 0: none
std::optional<WallRefusal> wall_refusal(const Scene &scene, const Pipe &pipe,
                                        const double bend_radius);

} // namespace frictionbeam
