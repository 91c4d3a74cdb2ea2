// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include "scene/scene.h"

#include <optional>

namespace frictionbeam {

/// A straight stretch of a line between two places that hold it aside, or from one to a free end.
/// It may pass from one pipe to the next.
struct PressedSpan {
  Station begin, end;
  bool has_free_end = false;
  bool has_nodes = false;  ///< between its ends
  double compression = 0.; ///< least along it [N]
  /// pi^2 EI/L^2 with ends that turn, a quarter of it with a free one [N]: what holds its ends
  /// less, or lets them give way, makes the load smaller at which it buckles, clamps make it
  /// larger.
  double euler_load = 0.;

  double ratio() const { return compression / euler_load; }
};

/// The span of a frame that is furthest beyond its Euler load, of those without nodes between their
/// ends. A support holds where it touches.
/// @param touching largest gap of a support that does, and distance of what is at one place [m]
std::optional<PressedSpan> most_pressed_span(const Scene &scene, const Results &results,
                                             const Frame &frame, const double touching);

} // namespace frictionbeam
