// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/sensitivity.h"

#include "study/design.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::study {

namespace {

/// Whether a run has a number for this result.
bool has_number(const Run &run, const std::size_t name) {
  return run.outcome == Outcome::converged && std::isfinite(run.numbers[name]);
}

/// Whether a result differs between runs by more than its rounding.
bool varies(const std::vector<double> &numbers) {
  constexpr double rounding = 1e-9;
  if (numbers.empty())
    return false;
  const auto [least, largest] = std::minmax_element(numbers.begin(), numbers.end());
  return *largest - *least > rounding * std::max(std::abs(*least), std::abs(*largest));
}

/// Results of one number a run that vary.
std::vector<std::size_t> names_that_vary(const StudyResults &study) {
  std::vector<std::size_t> names;
  for (std::size_t name = 0; name < study.names.size(); ++name)
    if (study.names[name].is_of_the_run() && varies(study.column(name)))
      names.push_back(name);
  return names;
}

std::vector<Sensitivity> by_rank(const StudyResults &study, const std::vector<std::size_t> &names,
                                 const Sampling &sampling) {
  constexpr std::size_t fewest = 4;
  std::vector<Sensitivity> found;
  Points points, results(names.size());
  for (std::size_t run = 0; run < study.runs.size(); ++run) {
    if (!std::all_of(names.begin(), names.end(),
                     [&](const std::size_t name) { return has_number(study.runs[run], name); }))
      continue;
    points.push_back(study.values[run]);
    for (std::size_t k = 0; k < names.size(); ++k)
      results[k].push_back(study.runs[run].numbers[names[k]]);
  }
  if (points.size() < fewest)
    return found;
  const Points correlations = sampling.rank_correlations(points, results);
  for (std::size_t k = 0; k < names.size(); ++k) {
    found.push_back({names[k], {}});
    for (const double correlation : correlations[k]) {
      found.back().effects.emplace_back();
      if (std::isfinite(correlation))
        found.back().effects.back().rank_correlation = correlation;
    }
  }
  return found;
}

/// Rows of Saltelli's design whose runs all have a number.
std::vector<std::size_t> whole_rows(const StudyResults &study, const std::size_t name) {
  const std::size_t n_rows = study.settings.n_runs, n_blocks = study.runs.size() / n_rows;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < n_rows; ++row) {
    bool whole = true;
    for (std::size_t block = 0; block < n_blocks; ++block)
      whole = whole && has_number(study.runs[block * n_rows + row], name);
    if (whole)
      rows.push_back(row);
  }
  return rows;
}

Sensitivity by_variance(const StudyResults &study, const std::size_t name,
                        const Sampling &sampling) {
  constexpr std::size_t fewest = 4;
  Sensitivity found{name, std::vector<Effect>(study.variables.size())};
  const std::vector<std::size_t> rows = whole_rows(study, name);
  Points points;
  std::vector<double> numbers;
  for (std::size_t block = 0; block < study.variables.size() + 2; ++block)
    for (const std::size_t row : rows) {
      const std::size_t run = block * study.settings.n_runs + row;
      points.push_back(study.design[run]);
      numbers.push_back(study.runs[run].numbers[name]);
    }
  if (rows.size() < fewest || !varies(numbers))
    return found;
  const SobolIndices indices = sampling.sobol_indices(points, numbers, rows.size());
  for (std::size_t i = 0; i < found.effects.size(); ++i) {
    found.effects[i].first = {indices.first[i], indices.first_low[i], indices.first_high[i]};
    found.effects[i].total = {indices.total[i], indices.total_low[i], indices.total_high[i]};
  }
  return found;
}

Sensitivity by_steps(const StudyResults &study, const std::size_t name,
                     const std::vector<MorrisStep> &steps) {
  Sensitivity found{name, std::vector<Effect>(study.variables.size())};
  std::vector<std::vector<double>> effects(study.variables.size());
  for (const MorrisStep &step : steps) {
    const std::size_t i = step.variable;
    const double change = study.values[step.after][i] - study.values[step.before][i];
    const Run &before = study.runs[step.before], &after = study.runs[step.after];
    if (change != 0. && has_number(before, name) && has_number(after, name))
      effects[i].push_back((after.numbers[name] - before.numbers[name]) / change * study.ranges[i]);
  }
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const double n = effects[i].size();
    if (n == 0.)
      continue;
    Effect::Elementary of{0., 0., 0., effects[i].size()};
    for (const double effect : effects[i]) {
      of.mean += effect / n;
      of.mean_size += std::abs(effect) / n;
    }
    for (const double effect : effects[i])
      of.deviation += (effect - of.mean) * (effect - of.mean);
    of.deviation = n > 1. ? std::sqrt(of.deviation / (n - 1.)) : 0.;
    found.effects[i].elementary = of;
  }
  return found;
}

} // namespace

double Effect::size() const {
  return total        ? total->value
         : elementary ? elementary->mean_size
                      : std::abs(rank_correlation.value_or(0.));
}

std::vector<Sensitivity> sensitivities(const StudyResults &study, const Sampling &sampling) {
  const std::vector<std::size_t> names = names_that_vary(study);
  if (study.settings.method != StudyMethod::morris &&
      study.settings.method != StudyMethod::sobol_indices)
    return by_rank(study, names, sampling);
  const std::vector<MorrisStep> steps = study.settings.method == StudyMethod::morris
                                            ? morris_steps(study.design)
                                            : std::vector<MorrisStep>();
  std::vector<Sensitivity> found;
  for (const std::size_t name : names)
    found.push_back(study.settings.method == StudyMethod::morris
                        ? by_steps(study, name, steps)
                        : by_variance(study, name, sampling));
  return found;
}

double correlation_by_chance(const std::size_t n_runs) {
  constexpr double sigmas = 1.96;
  return n_runs > 1 ? sigmas / std::sqrt(n_runs - 1.) : 1.;
}

} // namespace frictionbeam::study
