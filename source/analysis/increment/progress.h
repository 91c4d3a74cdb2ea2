// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"

#include <functional>

namespace frictionbeam {

/// How far a sequence of load steps is.
struct Progress {
  unsigned int step = 0, increment = 0;
  unsigned int n_increments = 0;
  /// The instant of the call before once more, behind a jump of forces or velocities.
  bool behind_jump = false;
  /// The end of a part that a declared increment has been cut into, but for the last.
  bool is_part = false;
};

/// Called with the start and then after each increment that the scene declares.
using Observer = std::function<void(const Progress &, const LineState &)>;

/// Whether the observer will look at more of a state than its contacts and the motion of monitored
/// points: elsewhere, a state of a reduced line may be that of an instant before.
using NeedsLine = std::function<bool(const Progress &, const double time)>;

/// Called between two increments, where the sequence may be written to an archive.
using Pause = std::function<void()>;

} // namespace frictionbeam
