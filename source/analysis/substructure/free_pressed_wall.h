// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/pressure_stiffness.h"

namespace frictionbeam {

/// Displacement of the closed wall that nothing holds under 1 Pa [m], but for a rigid motion.
/// @param wall with held points @param body_scene its materials
ContinuumVector free_pressed_wall(const Scene &body_scene, const PipeWall &wall);

} // namespace frictionbeam
