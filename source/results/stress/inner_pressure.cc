// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/stress/inner_pressure.h"

#include "scene/steps/history_origins.h"
#include "scene/steps/step_tree.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr unsigned int n_instants = 1000; ///< of a transient step, beside its corners

/// A pressure of a step's loads, its history in the time of the run.
struct Part {
  double size; ///< with its factor [Pa]
  const TimeFunction &history;
  double origin; ///< of its time [s]

  double before(const double time) const { return size * history.before(time - origin); }
  double after(const double time) const { return size * history.after(time - origin); }
};

std::vector<Part> parts_of(const Scene &scene, const unsigned int step, const unsigned int pipe) {
  std::vector<Part> parts;
  const HistoryOrigins origins(scene, step);
  for (const auto &[l, factor] : scene.steps[step].loads) {
    const Load &load = scene.loads[l];
    const auto &pipes = load.pipes;
    if (load.kind == Load::Kind::pressure &&
        (pipes.empty() || std::count(pipes.begin(), pipes.end(), scene.pipes[pipe].name) > 0))
      parts.push_back({factor * load.value, load.history, origins.loads[l]});
  }
  return parts;
}

double sum(const std::vector<Part> &parts, const double time,
           double (Part::*const side)(double) const) {
  double result = 0.;
  for (const Part &part : parts)
    result += (part.*side)(time);
  return result;
}

PressureBounds bounds_of_step(const Scene &scene, const unsigned int step,
                              const unsigned int pipe) {
  const std::vector<Part> parts = parts_of(scene, step, pipe);
  const LoadStep &declared = scene.steps[step];
  double begin = 0.;
  for (unsigned int s = 0; s < step; ++s)
    begin += scene.steps[s].duration;
  const double end = begin + declared.duration, at_end = sum(parts, end, &Part::before);
  PressureBounds result{at_end, at_end};
  if (!declared.transient)
    return result;
  const auto take = [&](const double pressure) {
    result.least = std::min(result.least, pressure);
    result.largest = std::max(result.largest, pressure);
  };
  std::vector<double> instants;
  for (unsigned int i = 0; i < n_instants; ++i)
    instants.push_back(begin + i * declared.duration / n_instants);
  for (const Part &part : parts)
    for (const double corner : part.history.breaks)
      instants.push_back(part.origin + corner);
  for (const double time : instants)
    if (time >= begin && time <= end) {
      take(sum(parts, time, &Part::after));
      if (time > begin)
        take(sum(parts, time, &Part::before));
    }
  if (const auto before = step_before(scene, step); before && declared.ramp > 0.) {
    const PressureBounds from = bounds_of_step(scene, *before, pipe); // which it ramps from
    take(from.least);
    take(from.largest);
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
