// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * Which frames of a transient step are written for ParaView, where there are more of them than
 * Output/VTU frames: at even distances of time, and the last one. Of static steps and of cases all
 * are.
 */
class FramesOfStep {
public:
  explicit FramesOfStep(const Scene &scene) : scene(scene) {}

  /// A step begins.
  void begin(const double time) {
    last = time;
    n_seen = n_written = 0;
  }
  bool takes(const Frame &frame);
  /// What was left out of the steps so far.
  const std::vector<std::string> &remarks() const { return left_out; }
  void transfer(Archive &archive) { archive(last, n_seen, n_written, left_out); }

private:
  const Scene &scene;
  double last = 0.; ///< time of the frame that was written last, or of the step's beginning
  unsigned int n_seen = 0, n_written = 0;
  std::vector<std::string> left_out;
};

} // namespace frictionbeam
