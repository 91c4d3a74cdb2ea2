// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/study_results.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::study {

std::size_t StudyResults::count(const Outcome outcome) const {
  return std::count_if(runs.begin(), runs.end(),
                       [&](const Run &run) { return run.outcome == outcome; });
}

std::vector<double> StudyResults::column(const std::size_t name, const std::size_t n_runs) const {
  std::vector<double> numbers;
  for (std::size_t run = 0; run < std::min(n_runs, runs.size()); ++run)
    if (runs[run].outcome == Outcome::converged && std::isfinite(runs[run].numbers[name]))
      numbers.push_back(runs[run].numbers[name]);
  return numbers;
}

} // namespace frictionbeam::study
