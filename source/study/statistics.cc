// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/statistics.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::study {

Quantile quantile(const std::vector<double> &sorted, const double probability) {
  Assert(!sorted.empty(), dealii::ExcInternalError());
  const double n = sorted.size(), place = probability * (n - 1.);
  const auto below = static_cast<std::size_t>(place);
  Quantile result;
  result.value = sorted[below];
  if (below + 1 < sorted.size())
    result.value += (place - below) * (sorted[below + 1] - sorted[below]);
  constexpr double sigmas = 1.959963984540054; // 95 % of a normal distribution
  const double half = sigmas * std::sqrt(n * probability * (1. - probability));
  const double first = std::floor(n * probability - half), last = std::ceil(n * probability + half);
  if (first >= 1.)
    result.low = sorted[static_cast<std::size_t>(first) - 1];
  if (last <= n - 1.)
    result.high = sorted[static_cast<std::size_t>(last)];
  return result;
}

Spread spread_of(const StudyResults &study, const std::size_t name) {
  Spread spread;
  std::vector<double> numbers;
  for (std::size_t run = 0; run < study.runs.size(); ++run) {
    if (study.runs[run].outcome != Outcome::converged)
      continue;
    const double number = study.runs[run].numbers[name];
    if (!std::isfinite(number))
      continue;
    if (numbers.empty() || number < spread.least) {
      spread.least = number;
      spread.least_run = run;
    }
    if (numbers.empty() || number > spread.largest) {
      spread.largest = number;
      spread.largest_run = run;
    }
    numbers.push_back(number);
  }
  spread.n = numbers.size();
  if (numbers.empty())
    return spread;
  for (const double number : numbers)
    spread.mean += number / numbers.size();
  for (const double number : numbers)
    spread.deviation += (number - spread.mean) * (number - spread.mean);
  spread.deviation = numbers.size() > 1 ? std::sqrt(spread.deviation / (numbers.size() - 1)) : 0.;
  std::sort(numbers.begin(), numbers.end());
  for (const double probability : study.settings.quantiles)
    spread.quantiles.push_back(quantile(numbers, probability));
  return spread;
}

StatusShares shares_of(const StudyResults &study, const std::size_t name) {
  StatusShares shares;
  const std::vector<double> numbers = study.column(name);
  for (const double number : numbers)
    switch (static_cast<ContactStatus>(static_cast<int>(number))) {
    case ContactStatus::stick:
      shares.stick += 1. / numbers.size();
      break;
    case ContactStatus::slip:
      shares.slip += 1. / numbers.size();
      break;
    case ContactStatus::open:
      shares.open += 1. / numbers.size();
      break;
    default:
      shares.closed += 1. / numbers.size();
    }
  return shares;
}

std::vector<std::size_t> convergence_runs(const StudyResults &study) {
  constexpr std::size_t fewest = 8, most_halves = 8;
  std::vector<std::size_t> numbers;
  if (study.settings.row().is_a_sample)
    for (std::size_t n = study.runs.size(); n >= fewest && numbers.size() < most_halves; n /= 2)
      numbers.push_back(n);
  std::reverse(numbers.begin(), numbers.end());
  return numbers;
}

} // namespace frictionbeam::study
