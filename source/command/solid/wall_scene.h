// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/body/body_sequence.h"
#include "mesh/solid/pipe_wall.h"
#include "model/body/tied_section.h"
#include "model/line_model.h"
#include "results/results.h"

namespace frictionbeam {

/// The scene as a body: the wall's materials, what is held and rubbed, and the steps. Its contacts
/// stand beside PipeWall::patches.
Scene scene_of_wall(const Scene &scene, const Model &line, const PipeWall &wall);

/// Where what is no anchor holds the wall.
std::vector<TiedSection> tied_sections(const Scene &scene, const Model &line, const PipeWall &wall);

/// @throws UserError where nothing holds the pipes, and for what is not done
void check_can_be_solid(const Scene &scene);

/// @throws UserError for a patch without a node
void check_patches(const Scene &scene, const PipeWall &wall, const ContinuumBody<3> &body);

/// What a strain of 1e-9 needs of the wall, below which all forces are rounding [N].
/// @param body_scene of the wall
double force_of_rounding(const Scene &body_scene, const PipeWall &wall);

/// What loads, anchors and supports leave: the sum of their forces, or of their moments about the
/// middle of the first section over the distance of the furthest one, of the largest of these.
/// @param load resultant of all loads [N, N m]
/// @param rounding force that the largest is not below [N]
double imbalance_of_supports(const Motion &load, const Results &results, const Frame &frame,
                             const PipeWall &wall, const ContinuumBody<3> &body,
                             const ContinuumState &state, const double rounding);

} // namespace frictionbeam
