// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/line/progress_line.h"

#include <unistd.h>

#include <cmath>
#include <iostream>

namespace frictionbeam {

namespace {

/// "40 s", "3 min", "2.5 h"
std::string duration_in_words(const double seconds) {
  constexpr double minute = 60., hour = 3600.;
  const auto whole = [](const double value) { return std::to_string(std::lround(value)); };
  if (seconds < 2. * minute)
    return whole(seconds) + " s";
  if (seconds < 2. * hour)
    return whole(seconds / minute) + " min";
  return whole(seconds / hour) + " h";
}

} // namespace

std::string progress_in_words(const std::string &step, const Progress &progress,
                              const unsigned int first, const double seconds) {
  std::string text = "step " + step + ": " + std::to_string(progress.increment) + " of " +
                     std::to_string(progress.n_increments) + ", " +
                     std::to_string(100ul * progress.increment / progress.n_increments) + " %";
  if (progress.increment > first)
    text += ", " +
            duration_in_words(seconds * (progress.n_increments - progress.increment) /
                              (progress.increment - first)) +
            " left in it";
  return text;
}

ProgressLine::ProgressLine(const Scene &scene)
    : scene(scene), on_terminal(!scene.output.quiet && isatty(STDERR_FILENO)),
      step_begin(Clock::now()), last(step_begin) {}

void ProgressLine::clear() {
  if (shown)
    std::cerr << "\r\033[K";
  shown = false;
}

void ProgressLine::show(const Progress &progress) {
  constexpr double between_lines = 30., between_words = 0.1; // [s], in a log and on a terminal
  if (scene.output.quiet)
    return;
  const Clock::time_point now = Clock::now();
  if (progress.n_increments == 0 || progress.step != step) { // begins, or goes on after a resume
    step_begin = now;
    step = progress.step;
    first = progress.increment;
  }
  const std::chrono::duration<double> since_begin = now - step_begin, since_last = now - last;
  if (progress.n_increments == 0 ||
      since_last.count() < (on_terminal ? between_words : between_lines))
    return;
  last = now;
  const std::string words = progress_in_words(scene.steps[progress.step].name, progress, first,
                                              since_begin.count());
  if (on_terminal)
    std::cerr << "\r\033[K" << words << std::flush;
  else
    std::cerr << words << std::endl;
  shown = on_terminal;
}

} // namespace frictionbeam
