// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/pipe_wall.h"
#include "model/body/body.h"
#include "model/line_model.h"
#include "results/results.h"

namespace frictionbeam {

/// The scene as a body: the wall's materials, what is held and rubbed, and the steps. Its contacts
/// stand beside PipeWall::patches.
Scene scene_of_wall(const Scene &scene, const Model &line, const PipeWall &wall);

/// @throws UserError where nothing holds the pipes, and for what is not done
void check_can_be_solid(const Scene &scene);

/// @throws UserError for a patch without a node
void check_patches(const Scene &scene, const PipeWall &wall, const ContinuumBody<3> &body);

/// Sum of the loads and of the forces of anchors and supports, of the largest of these.
/// @param load resultant of all loads [N]
double imbalance_of_supports(const Vector3 &load, const Model &line, const Frame &frame);

} // namespace frictionbeam
