// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/frame_choice.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

double largest_motion(const Frame &frame) {
  double largest = 0.;
  for (const Station &station : frame.line)
    largest = std::max(largest, std::hypot(station.displacement[0], station.displacement[1],
                                           station.displacement[2]));
  return largest;
}

std::vector<const Frame *> few_of(const std::vector<const Frame *> &frames,
                                  const unsigned int n_most) {
  if (frames.size() <= n_most)
    return frames;
  std::vector<const Frame *> chosen;
  for (unsigned int i = 0; i < n_most; ++i)
    chosen.push_back(
        frames[n_most == 1 ? frames.size() - 1 : i * (frames.size() - 1) / (n_most - 1)]);
  return chosen;
}

std::vector<const Frame *> frames_to_show(const Results &results, const unsigned int n_most) {
  std::vector<const Frame *> ends;
  for (const Frame &frame : results.frames)
    if (frame.end_of_step)
      ends.push_back(&frame);
  if (!results.frames.empty() && !results.frames.back().end_of_step)
    ends.push_back(&results.frames.back());
  return few_of(ends, n_most);
}

std::vector<const Frame *> frames_of_report(const Scene &scene, const Results &results) {
  constexpr unsigned int n_most = 24, n_of_long_lines = 6;
  constexpr std::size_t n_stations_of_long_lines = 5000, n_chosen_at_most = 64;
  const auto &wanted = scene.output.steps;
  if (wanted.empty())
    return frames_to_show(results, !results.frames.empty() && results.frames.front().line.size() >
                                                                  n_stations_of_long_lines
                                       ? n_of_long_lines
                                       : n_most);
  std::vector<const Frame *> chosen;
  for (const Frame &frame : results.frames)
    if (frame.end_of_step && chosen.size() < n_chosen_at_most &&
        std::count(wanted.begin(), wanted.end(), frame.name) > 0)
      chosen.push_back(&frame);
  return chosen.empty() ? frames_to_show(results, 1) : chosen;
}

} // namespace frictionbeam
