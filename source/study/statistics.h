// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "study/study_results.h"

namespace frictionbeam::study {

/// A quantile, and within which bounds it is with a probability of 95 %.
struct Quantile {
  double value = 0.;
  std::optional<double> low, high; ///< none: the runs are too few to bound it
};

/**
 * The quantile of a sample at a probability p: the sorted numbers at place p (n - 1), linearly in
 * between (Hyndman and Fan's type 7, doi 10.1080/00031305.1996.10473566). The bounds are order
 * statistics, whatever the distribution: the places n p +- 1.96 sqrt(n p (1 - p)) of a binomial
 * number's normal limit, which hold for random points and are wide for those spread more evenly.
 * @param sorted at least one number
 */
Quantile quantile(const std::vector<double> &sorted, const double probability);

/// What the runs say of one number.
struct Spread {
  std::size_t n = 0; ///< runs with such a number; without one, nothing below is known
  double least = 0., largest = 0., mean = 0., deviation = 0.;
  std::size_t least_run = 0, largest_run = 0;
  std::vector<Quantile> quantiles; ///< beside StudySettings::quantiles
};

Spread spread_of(const StudyResults &study, const std::size_t name);

/// Parts of the runs in which a support has each status at a step's end.
struct StatusShares {
  double stick = 0., slip = 0., open = 0., closed = 0.;
};
StatusShares shares_of(const StudyResults &study, const std::size_t name);

/// Numbers of runs at which quantiles are looked at, to see how they settle: halves of all, rising.
/// None of a design that is no sample.
std::vector<std::size_t> convergence_runs(const StudyResults &study);

} // namespace frictionbeam::study
