// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/pipe_wall.h"

namespace frictionbeam {

/**
 * Where the scene's supports are pressed against the wall: over Support/Width along the axis, one
 * outer diameter unless it is given, and 30 degrees of the circumference around the direction that
 * the support pushes from.
 * @param wall whose segments are there, but no rings and cells yet
 * @throws UserError for patches that leave the pipe, do not lie on one straight run, cover an
 * anchor, or push along the pipe
 */
std::vector<WallPatch> lay_patches(const Scene &scene, const LineMesh &line, const PipeWall &wall);

} // namespace frictionbeam
