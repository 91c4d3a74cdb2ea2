// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/design.h"

#include "base/number_text.h"
#include "base/user_error.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace frictionbeam::study {

namespace {

constexpr double most_runs = 1e6; // whose results have a place in memory

/// Every combination; the last variable changes fastest.
Points factorial(const Variables &variables) {
  Points points = {{}};
  for (std::size_t i = 0; i < variables.size(); ++i) {
    Points longer;
    for (const std::vector<double> &point : points)
      for (const double level : levels_of(variables.variation(i))) {
        longer.push_back(point);
        longer.back().push_back(level);
      }
    points = std::move(longer);
  }
  return points;
}

constexpr unsigned int morris_levels = 4;               ///< of the grid
constexpr unsigned int morris_jump = morris_levels / 2; ///< by 2/3 of its range (Morris 1991)

/// Probability of a level of the grid. Where a distribution has a tail, 0 and 1 have no value.
double probability_of(const unsigned int level, const Variation &variation) {
  constexpr double tail = 0.01;
  const bool has_tails = variation.shape != Variation::Shape::list &&
                         (std::isinf(variation.from) || std::isinf(variation.to));
  const double u = level / (morris_levels - 1.);
  return has_tails ? tail + u * (1. - 2. * tail) : u;
}

/**
 * Morris' ways through the grid: each begins at a point of it and changes one variable after the
 * other, in random order, by 2/3 (M. D. Morris, Technometrics 33, 1991, doi
 * 10.1080/00401706.1991.10484804). Of distributions with tails the grid goes from 1 % to 99 %.
 */
Points morris(const unsigned int n_ways, const Variables &variables, const unsigned int seed) {
  std::mt19937_64 generator(seed);
  const auto below = [&](const std::size_t n) { return generator() % n; };
  const std::size_t d = variables.size();
  Points points;
  const auto add = [&](const std::vector<unsigned int> &levels) {
    std::vector<double> point;
    for (std::size_t i = 0; i < d; ++i)
      point.push_back(probability_of(levels[i], variables.variation(i)));
    points.push_back(point);
  };
  for (unsigned int way = 0; way < n_ways; ++way) {
    std::vector<unsigned int> levels(d);
    for (unsigned int &level : levels)
      level = below(morris_levels);
    std::vector<std::size_t> order(d);
    std::iota(order.begin(), order.end(), std::size_t(0));
    for (std::size_t i = d; i > 1; --i)
      std::swap(order[i - 1], order[below(i)]);
    add(levels);
    for (const std::size_t i : order) {
      levels[i] =
          (levels[i] + morris_jump) % morris_levels; // up from the lower half, down from the upper
      add(levels);
    }
  }
  return points;
}

double n_runs_of(const StudySettings &settings, const Variables &variables) {
  const double d = variables.size();
  switch (settings.method) {
  case StudyMethod::factorial: {
    double n = 1.;
    for (std::size_t i = 0; i < variables.size(); ++i)
      n *= levels_of(variables.variation(i)).size();
    return n;
  }
  case StudyMethod::sobol_indices:
    return settings.n_runs * (d + 2.);
  case StudyMethod::morris:
    return settings.n_runs * (d + 1.);
  default:
    return settings.n_runs;
  }
}

} // namespace

Points make_design(const StudySettings &settings, const Variables &variables,
                   const Sampling &sampling) {
  if (const double n = n_runs_of(settings, variables); n > most_runs)
    throw UserError(
        "The study has too many runs.\n  read:    " + rounded_number(n, 8) + " runs of " +
        std::to_string(variables.size()) + " variables by Method = " + settings.row().word +
        "\n  allowed: " + rounded_number(most_runs, 8) +
        "\n  try:     fewer Runs or Levels; Method = latin hypercube, whose Runs do not "
        "grow with the number of variables");
  const unsigned int n = settings.n_runs, d = variables.size(), seed = settings.seed;
  switch (settings.method) {
  case StudyMethod::latin_hypercube:
    return sampling.latin_hypercube(n, d, seed);
  case StudyMethod::sobol_sequence:
    return sampling.sobol_sequence(n, d, seed);
  case StudyMethod::random:
    return sampling.random(n, d, seed);
  case StudyMethod::sobol_indices:
    return sampling.saltelli(n, d, seed);
  case StudyMethod::factorial:
    return factorial(variables);
  case StudyMethod::morris:
    break;
  }
  return morris(n, variables, seed);
}

std::vector<double> morris_ranges(const Variables &variables) {
  std::vector<double> ranges;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    std::vector<double> values;
    for (unsigned int level = 0; level < morris_levels; ++level)
      values.push_back(variables.value(i, probability_of(level, variables.variation(i))));
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    ranges.push_back(*largest - *least);
  }
  return ranges;
}

std::vector<MorrisStep> morris_steps(const Points &design) {
  std::vector<MorrisStep> steps;
  const std::size_t d = design.empty() ? 0 : design.front().size();
  for (std::size_t run = 1; run < design.size(); ++run) {
    if (run % (d + 1) == 0)
      continue; // the next way begins
    for (std::size_t i = 0; i < d; ++i)
      if (design[run][i] != design[run - 1][i])
        steps.push_back({run - 1, run, i});
  }
  return steps;
}

} // namespace frictionbeam::study
