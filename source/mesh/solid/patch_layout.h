// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/pipe_wall.h"

namespace frictionbeam {

/// Unit direction in which a support pushes the pipe.
Vector3 push_of(const FrictionSupport &support, const Vector3 &tangent);

/// Of the cosine between the two: a push is square to the pipe, or along it.
constexpr double square_enough = 1e-3;

/// Of the outer radius: places along the pipe that have one ring of the mesh.
constexpr double one_place = 1e-3;

/**
 * Where the scene's supports are pressed against the wall: over Support/Width along the axis, one
 * outer diameter unless it is given, and 30 degrees of the circumference around the direction that
 * the support pushes from. What pushes along the pipe has a collar all round it, the third of that
 * width that is furthest in the direction of the push: between the two collars of a line stop there
 * is room for what stops them.
 * @param wall whose segments are there, but no rings and cells yet
 * @throws UserError for patches that are narrower than rings, leave the pipe, do not lie on one
 * straight run, cover an anchor, or push askew
 */
std::vector<WallPatch> lay_patches(const Scene &scene, const LineMesh &line, const PipeWall &wall);

} // namespace frictionbeam
