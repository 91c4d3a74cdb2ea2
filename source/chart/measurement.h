// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "chart/chart_list.h"

#include <limits>
#include <optional>

namespace frictionbeam::chart {

/// A quantity of a run.
struct Value {
  std::string name, unit;
  double value = 0.;
  std::optional<double> reference;
};

/// What the runs of one configuration gave.
struct Measurement {
  std::size_t curve = 0;     ///< place in the list
  std::string setting;       ///< the varied values, as in the list
  std::string problem;       ///< why there is no answer; empty if there is
  std::vector<Value> values; ///< of the quantities that count
  double error = std::numeric_limits<double>::quiet_NaN();
  std::string worst;           ///< quantity with the largest error
  std::vector<double> seconds; ///< of each run, ascending, as Time says
  double process_seconds = 0.; ///< median, from start to end
  double peak_memory_mb = 0.;
  std::size_t unknowns = 0; ///< 0: not known

  bool solved() const { return problem.empty(); }
  double median() const; ///< of seconds; nan if there are none
};

/**
 * Run all configurations of a list, each run a process of its own, the curves' runs one after the
 * other and all of them Runs times, so that a disturbance of the machine does not hit one curve.
 * @throws UserError if the reference run fails, or no error can be measured.
 */
std::vector<Measurement> measure(const ChartList &list);

/// Median; nan if there is no number. @p numbers are sorted.
double median_of(std::vector<double> &numbers);

} // namespace frictionbeam::chart
