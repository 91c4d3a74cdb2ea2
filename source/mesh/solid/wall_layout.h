// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/pipe_wall.h"

namespace frictionbeam {

/**
 * Lay out the wall of a scene's pipes: rings at the ends of bends, at named points, supports and
 * anchors and at the edges of patches, between them bends in equal layers and straight runs in
 * layers that grow away from what disturbs them.
 * @param line the scene's mesh as a line, which knows where supports stand
 * @param halved further rings, along the chain [m]
 * @throws UserError for what is no chain of straight runs and bends of one section, and for patches
 * that leave a straight run or meet
 */
PipeWall build_pipe_wall(const Scene &scene, const LineMesh &line,
                         const std::vector<double> &halved = {});

} // namespace frictionbeam
