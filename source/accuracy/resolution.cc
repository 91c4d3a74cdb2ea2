// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/resolution.h"

#include "base/numbers.h"
#include "results/how_well_known.h"
#include "scene/steps/history_origins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam::accuracy {

namespace {

constexpr double largest_deviation = 0.1; ///< of a history from straight lines, of its range
constexpr unsigned int n_points = 16384;  ///< of a transient step
constexpr double shortest_part = 1. / 8192.;
constexpr double safety = 2.; ///< of a difference of two answers, as a measure of their error

/// Largest distance of a history from straight lines between instants @p step apart, over its
/// range.
double deviation(const TimeFunction &history, const double start, const double end,
                 const double step) {
  double low = history.after(start), high = low, largest = 0.;
  for (double begin = start; begin < end;) {
    const auto corner = std::upper_bound(history.breaks.begin(), history.breaks.end(),
                                         begin + 1e-12 * (end - start));
    const double last = corner != history.breaks.end() ? std::min(*corner, end) : end;
    const unsigned int n = std::max(1., std::ceil((last - begin) / step - same_instant_of_step)),
                       inside = std::max(2., n_points * step / (end - start));
    for (unsigned int i = 0; i < n; ++i) {
      const double t0 = begin + (last - begin) * i / n, t1 = begin + (last - begin) * (i + 1) / n,
                   f0 = history.after(t0), f1 = history.before(t1);
      low = std::min({low, f0, f1});
      high = std::max({high, f0, f1});
      for (unsigned int k = 1; k < inside; ++k) {
        const double part = static_cast<double>(k) / inside, f = history(t0 + part * (t1 - t0));
        low = std::min(low, f);
        high = std::max(high, f);
        largest = std::max(largest, std::abs(f - f0 - part * (f1 - f0)));
      }
    }
    begin = last;
  }
  return high > low ? largest / (high - low) : 0.;
}

} // namespace

double longest_time_step(const Scene &scene) {
  double shortest = 0.;
  for (const LoadStep &step : scene.steps)
    if (step.transient)
      shortest = shortest == 0. ? step.duration : std::min(shortest, step.duration);
  double longest = shortest / 64., begin = 0.;
  for (unsigned int s = 0; s < scene.steps.size(); begin += scene.steps[s++].duration) {
    const LoadStep &step = scene.steps[s];
    if (!step.transient)
      continue;
    const HistoryOrigins origins(scene, s);
    const auto follow = [&](const TimeFunction &history, const double origin) {
      if (!history.is_given() || std::isfinite(history.begins)) // a table is straight
        return;
      const double start = begin - origin;
      while (longest > shortest_part * step.duration &&
             deviation(history, start, start + step.duration, longest) > largest_deviation)
        longest /= 2.;
    };
    for (const auto &[load, factor] : step.loads)
      if (factor != 0.)
        follow(scene.loads[load].history, origins.loads[load]);
    for (const FrictionSupport &support : scene.supports)
      for (const TimeFunction &motion : support.ground_motion)
        follow(motion, origins.of_ground(motion));
  }
  return longest;
}

std::string nearly_missed(const Results &coarse, const Results &fine) {
  for (std::size_t s = 0; s < std::min(coarse.steps.size(), fine.steps.size()); ++s) {
    const std::vector<ContactMargin> &before = coarse.steps[s].margins,
                                     &now = fine.steps[s].margins;
    for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i) {
      const auto is_near = [](const double a, const double b) {
        return std::isfinite(a) && std::isfinite(b) && a > 0. && b > 0. &&
               safety * std::abs(a - b) > b;
      };
      const std::string where =
          fine.supports[fine.support_of[i]].name + " in step " + fine.steps[s].step;
      if (is_near(before[i].slip, now[i].slip))
        return "slip at " + where;
      if (is_near(before[i].opening, now[i].opening))
        return "lifting off at " + where;
      if (is_near(before[i].closing, now[i].closing))
        return "closing of the gap at " + where;
    }
  }
  return "";
}

double hidden_in_one_increment(const Scene &scene, const Results &results) {
  double hidden = 0., moved = 0.;
  for (const StepReport &step : results.steps)
    moved = std::max(moved, step.resolution.largest_displacement);
  for (std::size_t s = 0; s < results.steps.size(); ++s) {
    const StepReport &step = results.steps[s];
    if (scene.steps[s].transient)
      continue;
    if (moved > 0.)
      hidden = std::max(hidden, step.resolution.slip_in_one / moved);
    if (step.resolution.flow_increments == 1 && step.energy.turnover > 0.)
      hidden = std::max(hidden, step.energy.inelastic / step.energy.turnover);
  }
  return hidden;
}

double unseen_between_sections(const Scene &, const Results &results) {
  return unseen_yield(results) > 0. ? std::numeric_limits<double>::infinity() : 0.;
}

} // namespace frictionbeam::accuracy
