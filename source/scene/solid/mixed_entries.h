// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include "scene/scene.h"

/// @file Where the wall of a line's pipes is a solid (Solid/At), and what such a mixed model knows.
namespace frictionbeam {

/// What Solid/At names, which is among Scene::asked_points by this entry: points, or all bends.
inline constexpr char solid_at[] = "Solid/At", all_bends[] = "all bends";

/// Names of the places where a line is solid; none: it is beams everywhere.
std::vector<std::string> solid_places(const Scene &scene);

namespace parts {

void declare_mixed(ParameterReader &in);
void parse_mixed(const ParameterReader &in, Scene &scene);

/// Refuses what beams know and solid parts in them do not.
void check_mixed(ParameterReader &in, const Scene &scene);

} // namespace parts
} // namespace frictionbeam
