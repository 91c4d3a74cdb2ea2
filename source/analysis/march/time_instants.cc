// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/march/time_instants.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double rounding = 1e-12; ///< of the run's time: instants that are one

void add_equal(const double start, const double end, const double longest,
               std::vector<double> &instants) {
  const std::size_t n = std::max(1., std::ceil((end - start) / longest - same_instant_of_step));
  for (std::size_t i = 1; i <= n; ++i)
    instants.push_back(i == n ? end : start + (end - start) * i / n);
}

} // namespace

std::vector<double> instants_of_steps(const LoadCourse &course, const double start,
                                      const double end, const double longest) {
  std::vector<double> result;
  const double least = rounding * std::abs(end);
  for (double now = start; now < end;) {
    double next = course.next_break(now + least);
    if (next > end - least)
      next = end;
    add_equal(now, next, longest, result);
    now = next;
  }
  return result;
}

std::vector<double> instants_of_output(const Model &model, const double start, const double end,
                                       const double longest) {
  std::vector<double> result;
  add_equal(start, end, longest, result);
  for (const Quantity &quantity : model.scene.quantities)
    if (quantity.time && *quantity.time > start && *quantity.time < end)
      result.push_back(*quantity.time);
  std::sort(result.begin(), result.end());
  const double least = same_instant_of_step * longest;
  std::vector<double> apart;
  for (const double instant : result) // of two that are next to one, the later
    if (!apart.empty() && instant - apart.back() < least)
      apart.back() = instant;
    else
      apart.push_back(instant);
  return apart;
}

} // namespace frictionbeam
