// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include "scene/scene.h"

/// @file Section Solid of a parameter file, and what a solid pipe knows of a scene of routes.
namespace frictionbeam::parts {

void declare_solid(ParameterReader &in);
void parse_solid(const ParameterReader &in, Scene &scene);

/// Of a scene that is solved as solid pipes: refuses every part and entry that these do not know.
/// Of another: a remark on what is not used.
void check_solid(ParameterReader &in, Scene &scene);

} // namespace frictionbeam::parts
