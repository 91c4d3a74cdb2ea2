// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"

namespace frictionbeam {

/**
 * What a step integrator may do wrong at friction elements of finite shear rigidity that are stiff
 * for the time step: what has stopped goes on to swing in the element with the velocity that it
 * had, and steps with (h omega)^2 > 4 neither follow that swing nor damp it, so that its force may
 * break static friction again and again. Empty if there are none.
 * @param with_rigid whether rigid elements are among them, having a stiffness by return mapping
 */
std::string warn_of_stiff_friction(const Model &model, const std::string &integrator,
                                   const bool with_rigid);

} // namespace frictionbeam
