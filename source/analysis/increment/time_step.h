// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"

namespace frictionbeam {

/// Time/Step, or the one that the mesh gives if it is 0 [s].
double time_step(const Model &model);
/// @throws UserError if a transient step takes more time steps than any machine does
void check_time_steps(const Model &model);

} // namespace frictionbeam
