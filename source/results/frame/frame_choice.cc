// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/frame_choice.h"

namespace frictionbeam {

std::vector<const Frame *> frames_to_show(const Results &results, const unsigned int n_most) {
  std::vector<const Frame *> ends;
  for (const Frame &frame : results.frames)
    if (frame.end_of_step)
      ends.push_back(&frame);
  if (!results.frames.empty() && !results.frames.back().end_of_step)
    ends.push_back(&results.frames.back());
  if (ends.size() <= n_most)
    return ends;
  std::vector<const Frame *> chosen;
  for (unsigned int i = 0; i < n_most; ++i)
    chosen.push_back(ends[n_most == 1 ? ends.size() - 1 : i * (ends.size() - 1) / (n_most - 1)]);
  return chosen;
}

} // namespace frictionbeam
