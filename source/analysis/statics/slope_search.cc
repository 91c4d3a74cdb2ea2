// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/slope_search.h"

#include <cmath>

namespace frictionbeam {

double search_slope(const double slope, const std::function<double(double)> &slope_at) {
  constexpr double most_overshoot = 0.5; // of the slope at the start
  constexpr unsigned int most_searches = 20;
  const double allowed = most_overshoot * std::abs(slope);
  double low = 0., high = 1., of_low = slope, of_high = slope_at(1.), last = 1.;
  for (unsigned int k = 0; k < most_searches && of_high > allowed; ++k) {
    const double secant = low - of_low * (high - low) / (of_high - of_low);
    last = k % 2 == 0 && secant > 0.01 * high ? secant : (low + high) / 2.;
    const double here = slope_at(last);
    if (std::abs(here) <= allowed)
      break;
    (here < 0. ? low : high) = last;
    (here < 0. ? of_low : of_high) = here;
  }
  return last;
}

} // namespace frictionbeam
