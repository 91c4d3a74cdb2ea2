// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/stress/inner_pressure.h"

#include "scene/steps/history_origins.h"
#include "scene/steps/step_factors.h"
#include "scene/steps/step_tree.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr unsigned int n_instants = 1000; ///< of a transient step, beside its corners

/// A pressure load of a step: its declared value goes evenly from one to another, times its history
/// in the time of the run.
struct Part {
  double from, to; ///< with its factors [Pa]
  const TimeFunction &history;
  double origin; ///< of its time [s]
};

std::vector<Part> parts_of(const Scene &scene, const unsigned int step, const unsigned int pipe) {
  std::vector<Part> parts;
  const HistoryOrigins origins(scene, step);
  const std::vector<double> to = declared_factors(scene, scene.steps[step]);
  const auto before = step_before(scene, step);
  const std::vector<double> from =
      before ? declared_factors(scene, scene.steps[*before]) : std::vector<double>(to.size(), 0.);
  for (std::size_t l = 0; l < to.size(); ++l) {
    const Load &load = scene.loads[l];
    const auto &pipes = load.pipes;
    if (load.kind == Load::Kind::pressure && (from[l] != 0. || to[l] != 0.) &&
        (pipes.empty() || std::count(pipes.begin(), pipes.end(), scene.pipes[pipe].name) > 0))
      parts.push_back({from[l] * load.value, to[l] * load.value, load.history, origins.loads[l]});
  }
  return parts;
}

PressureBounds bounds_of_step(const Scene &scene, const unsigned int step,
                              const unsigned int pipe) {
  const std::vector<Part> parts = parts_of(scene, step, pipe);
  const LoadStep &declared = scene.steps[step];
  double begin = 0.;
  for (unsigned int s = 0; s < step; ++s)
    begin += scene.steps[s].duration;
  const double end = begin + declared.duration,
               ramp = declared.transient ? declared.ramp : declared.duration;
  const auto pressure = [&](const double time,
                            double (TimeFunction::*const side)(double, double) const) {
    const double ramped = time < begin + ramp ? std::max(0., (time - begin) / ramp) : 1.;
    double sum = 0.;
    for (const Part &part : parts)
      sum += (part.from + ramped * (part.to - part.from)) *
             (part.history.*side)(time - part.origin, 0.);
    return sum;
  };
  const double at_end = pressure(end, &TimeFunction::before);
  PressureBounds result{at_end, at_end};
  if (!declared.transient)
    return result;
  const auto take = [&](const double value) {
    result.least = std::min(result.least, value);
    result.largest = std::max(result.largest, value);
  };
  std::vector<double> instants = {begin + ramp};
  for (unsigned int i = 0; i < n_instants; ++i)
    instants.push_back(begin + i * declared.duration / n_instants);
  for (const Part &part : parts)
    for (const double corner : part.history.breaks)
      instants.push_back(part.origin + corner);
  for (const double time : instants)
    if (time >= begin && time <= end) {
      take(pressure(time, &TimeFunction::after));
      if (time > begin)
        take(pressure(time, &TimeFunction::before));
    }
  return result;
}

} // namespace

PressureBounds pressure_bounds(const Scene &scene, const std::string &step,
                               const unsigned int pipe) {
  for (unsigned int s = 0; s < scene.steps.size(); ++s)
    if (scene.steps[s].name == step)
      return bounds_of_step(scene, s, pipe);
  using Kind = Combination::Kind;
  for (const Combination &combination : scene.combinations) {
    if (combination.name != step)
      continue;
    PressureBounds sum, all;
    double sizes = 0., squares = 0.;
    bool is_first = true;
    for (const auto &[name, factor] : combination.cases) {
      const PressureBounds part = pressure_bounds(scene, name, pipe);
      const auto [least, largest] = std::minmax({factor * part.least, factor * part.largest});
      const double size = std::max(std::abs(least), std::abs(largest));
      sum = {sum.least + least, sum.largest + largest};
      all = is_first ? PressureBounds{least, largest}
                     : PressureBounds{std::min(all.least, least), std::max(all.largest, largest)};
      sizes += size;
      squares += size * size;
      is_first = false;
    }
    switch (combination.kind) {
    case Kind::sum:
      return sum;
    case Kind::absolute:
      return {-sizes, sizes};
    case Kind::srss:
      return {-std::sqrt(squares), std::sqrt(squares)};
    case Kind::range:
      return {all.least - all.largest, all.largest - all.least};
    default:
      return all;
    }
  }
  return {};
}

double pressure_in(const Scene &scene, const std::string &step, const unsigned int pipe) {
  const PressureBounds bounds = pressure_bounds(scene, step, pipe);
  return std::abs(bounds.least) > std::abs(bounds.largest) ? bounds.least : bounds.largest;
}

} // namespace frictionbeam
