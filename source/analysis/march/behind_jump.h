// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/load_course.h"

namespace frictionbeam {

/**
 * The instant behind a jump of loads or ground, to be shown beside the one before it. What has
 * mass is where it was and as fast; what jumps are the accelerations, the motions that loads and
 * ground impose, where nodes without mass are, and the forces of contacts. The last two are those
 * at the end of two steps that are short beside a time step, of which the first takes the impulses
 * there may be. They are made by Newmark's method, whatever takes the run's steps.
 * @param state of which factors, rates and velocities are those behind the jump already
 */
LineState state_behind_jump(const Model &model, const LoadCourse &course, const LineState &state);

} // namespace frictionbeam
