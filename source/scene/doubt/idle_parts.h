// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/**
 * Say what parts do nothing (Scene::remarks): springs without stiffness, masses of 0 kg, joints
 * that are rigid, bends where a route goes straight on, initial motions in directions that are
 * held, and loads that no step names. Such a load of displacements holds its points no more.
 */
void remark_on_idle_parts(Scene &scene);

} // namespace frictionbeam
