// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/progress.h"

#include <chrono>

namespace frictionbeam {

/**
 * How far a run is: on a terminal a line that is written over; in a log, where stderr goes
 * elsewhere, a line of its own every half a minute. Nothing if the scene's output is quiet. The
 * time left is that of the step, if its increments go on to take as long as they did.
 */
class ProgressLine {
public:
  explicit ProgressLine(const Scene &scene);
  ~ProgressLine() { clear(); }

  /// Take the line from the terminal.
  void clear();
  void show(const Progress &progress);

private:
  using Clock = std::chrono::steady_clock;

  const Scene &scene;
  const bool on_terminal;
  bool shown = false;
  Clock::time_point step_begin, last; ///< last: that a line was written
  unsigned int step = 0, first = 0;   ///< increment that the step was at when it began here
};

/// "step quake: 120 of 400, 30 %, 2 min left in it"
std::string progress_in_words(const std::string &step, const Progress &progress,
                              const unsigned int first, const double seconds);

} // namespace frictionbeam
