// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"

#include <functional>

namespace frictionbeam {

/**
 * A stretch of a motion in which everything is smooth: no contact changes its state and no load
 * jumps or bends. Extremes over time are the largest of those within pieces and at their ends,
 * where a piece has its own limit: before and after an impact, a velocity has two values.
 */
struct MotionPiece {
  double begin = 0., end = 0.; ///< [s]
  /// The line at any instant of [begin, end]; valid until the next call.
  std::function<const LineState &(const double time)> state_at;
  bool is_reduced = false; ///< of a line on few unknowns, which is written back at each of these
};

/// Called with the pieces of a motion in the order of time.
using PieceObserver = std::function<void(const MotionPiece &)>;

} // namespace frictionbeam
