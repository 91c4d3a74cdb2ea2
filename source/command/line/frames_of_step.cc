// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/line/frames_of_step.h"

namespace frictionbeam {

bool FramesOfStep::takes(const Frame &frame) {
  constexpr double rounding = 1e-6; // of the distance
  const unsigned int most = scene.output.vtu_frames;
  if (most == 0 || frame.step >= scene.steps.size() || !scene.steps[frame.step].transient)
    return true;
  const LoadStep &step = scene.steps[frame.step];
  ++n_seen;
  const bool is_taken =
      frame.end_of_step || frame.time - last >= step.duration / most * (1. - rounding);
  if (is_taken) {
    last = frame.time;
    ++n_written;
  }
  if (frame.end_of_step && n_written < n_seen)
    left_out.push_back("Step " + step.name + ": of its " + std::to_string(n_seen) +
                       " instants of output " + std::to_string(n_written) +
                       " are written for ParaView. Output/VTU frames = 0 writes all, Time/Output "
                       "interval makes fewer of everything.");
  if (frame.end_of_step)
    n_seen = n_written = 0;
  return is_taken;
}

} // namespace frictionbeam
