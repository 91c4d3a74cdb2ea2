// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/**
 * The same line with pipes cut in the straight runs between their bends, so that each has one bend
 * at most, and a flexibility of its own. Pipes of which something else than supports and loads
 * speaks (quantities, joints, tees, beds, masses of whole pipes) are left whole, and reducers.
 * @param owner of each new pipe, the old one
 */
Scene with_pipe_of_each_bend(Scene scene, std::vector<unsigned int> &owner);

} // namespace frictionbeam
