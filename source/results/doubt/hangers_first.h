// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include "scene/scene.h"

namespace frictionbeam {

/// Say that hangers have pulled with their whole cold load before the weight was there: in the
/// first step of a run, where its increments are several, and something slipped or yielded in it.
void remark_on_hangers_first(const Scene &scene, Results &results);

} // namespace frictionbeam
