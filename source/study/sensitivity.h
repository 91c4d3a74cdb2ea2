// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "study/study_results.h"

namespace frictionbeam::study {

/// What one variable does to a result. Which of it is known depends on the study's method.
struct Effect {
  /// Spearman's rank correlation, -1 to 1: of samples and factorial designs.
  std::optional<double> rank_correlation;
  /// Shares of the variance, with 95 % confidence: of Method = sobol indices.
  struct Share {
    double value, low, high;
  };
  std::optional<Share> first, total;
  /// Morris' mean, mean size and deviation of the elementary effects, in the result's unit for the
  /// variable's whole range (doi 10.1016/j.envsoft.2006.10.004 for the mean size).
  struct Elementary {
    double mean, mean_size, deviation;
    std::size_t n; ///< of effects
  };
  std::optional<Elementary> elementary;

  /// By which variables are put in order.
  double size() const;
};

/// Of one result, the effect of each variable.
struct Sensitivity {
  std::size_t name = 0; ///< place in StudyResults::names
  std::vector<Effect> effects;
};

/// Of results that are one for a run and vary. Runs without an answer are left out, and with them
/// the rows of Saltelli's design and the steps of Morris' that need them.
std::vector<Sensitivity> sensitivities(const StudyResults &study, const Sampling &sampling);

/// Rank correlations below this size are what @p n_runs independent runs would show by chance, with
/// a probability of 5 %.
double correlation_by_chance(const std::size_t n_runs);

} // namespace frictionbeam::study
