// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"
#include "scene/scene.h"

#include <string>

namespace frictionbeam {

/**
 * Where a stress code, which takes factors from bends and tees alone, has nothing for what the
 * routes draw: pipes that branch without a section Tee, and corners of more than 3 degrees that are
 * not rounded (miters), in a sentence; empty if there are none. Rigid pipes do not count, nor lines
 * that come from a mesh file, whose bends may be chords.
 */
std::string unintensified_places(const Scene &scene, const LineMesh &mesh);

} // namespace frictionbeam
