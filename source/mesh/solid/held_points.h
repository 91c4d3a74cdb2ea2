// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/pipe_wall.h"
#include "scene/body.h"

namespace frictionbeam {

/// Name six displacements of points of the first ring that hold the wall as a whole and need no
/// force for loads in balance: of four points those that a pivoting factorization of their rigid
/// motions takes first.
PipeWall with_held_points(PipeWall wall);

/// Of the displacements that are named so.
std::vector<ContinuumHold> holds_at_points(const PipeWall &wall);

} // namespace frictionbeam
