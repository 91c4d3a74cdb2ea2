// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// Force of a friction support on the pipe, global axes [N].
inline Vector3 force_in_space(const SupportState &state) {
  return Vector3({state.on_pipe[0], state.on_pipe[1], state.on_pipe[2]});
}

} // namespace frictionbeam
