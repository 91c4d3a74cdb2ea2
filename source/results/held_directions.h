// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include "scene/scene.h"

namespace frictionbeam {

/// Unit directions in which a restraint holds or a spring acts, those of a turn left out.
std::vector<Vector3> held_directions(const Scene &scene, const RestraintInfo &info,
                                     const Station &station);

} // namespace frictionbeam
