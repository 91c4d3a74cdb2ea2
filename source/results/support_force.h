// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// Force of a friction support on the pipe, global axes [N].
inline Vector3 force_in_space(const SupportInfo &info, const SupportState &state) {
  return state.fn * info.normal + state.ft1 * info.t1 + state.ft2 * info.t2;
}

} // namespace frictionbeam
