// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/inelastic/section_charts.h"

#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double no_part = 0.01;        ///< of the work of all: not worth a chart
constexpr double decades = 100.;        ///< longest over shortest increment that call for log time
constexpr double long_in_seconds = 1e5; ///< times above are shown in hours
constexpr std::size_t few_points = 60;  ///< that are marked

/// A force of a section and the strain on which it does work, by instants.
struct Pair {
  std::string force_name, force_unit, strain_name, strain_unit;
  std::vector<double> force, strain;

  /// What it did at most, of the size of a work [J/m].
  double most() const {
    double result = 0.;
    for (std::size_t i = 0; i < force.size(); ++i)
      result = std::max(result, std::abs(force[i] * strain[i]));
    return result;
  }
};

Pair pair_of(const SectionHistory &history, const unsigned int component, const Pair &names) {
  Pair pair = names;
  for (const SectionState &state : history.states) {
    pair.force.push_back(state.force[component]);
    pair.strain.push_back(state.strain[component]);
  }
  return pair;
}

/// About the axis of the largest moment.
Pair bending_of(const SectionHistory &history) {
  Pair pair{"bending moment", "N m", "curvature", "1/m", {}, {}};
  double largest = 0., y = 1., z = 0.; // the axis
  for (const SectionState &state : history.states)
    if (const double moment = std::hypot(state.force[4], state.force[5]); moment > largest) {
      largest = moment;
      y = state.force[4] / moment;
      z = state.force[5] / moment;
    }
  for (const SectionState &state : history.states) {
    pair.force.push_back(y * state.force[4] + z * state.force[5]);
    pair.strain.push_back(y * state.strain[4] + z * state.strain[5]);
  }
  return pair;
}

/// Those that do a part of the work, the greatest first.
std::vector<Pair> working_pairs(const SectionHistory &history) {
  std::vector<Pair> pairs{bending_of(history),
                          pair_of(history, 0, {"axial force", "N", "strain", "-", {}, {}}),
                          pair_of(history, 3, {"torsional moment", "N m", "twist", "1/m", {}, {}})};
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair &a, const Pair &b) { return a.most() > b.most(); });
  const double least = no_part * pairs.front().most();
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [&](const Pair &pair) { return pair.most() <= least; }),
              pairs.end());
  return pairs;
}

/// A strain in percent, else in the units of the file.
DisplayUnit unit_of_strain(const UnitSystem &units, const Pair &pair) {
  if (pair.strain_unit == "-")
    return {100., "%"};
  return {1. / units.factor(pair.strain_unit), units.name(pair.strain_unit)};
}

std::vector<double> times(const double factor, std::vector<double> values) {
  for (double &value : values)
    value *= factor;
  return values;
}

double largest_of(const std::vector<double> &values) {
  Largest largest;
  for (const double value : values)
    largest(value);
  return largest.value();
}

Plot::Series series_of(const std::vector<double> &x, const std::vector<double> &y) {
  Plot::Series series;
  series.x = x;
  series.y = y;
  if (x.size() <= few_points)
    series.style = Plot::Series::Style::line_points;
  return series;
}

Plot force_over_strain(const UnitSystem &units, const SectionHistory &history, const Pair &pair) {
  const DisplayUnit force = display_unit(units, pair.force_unit, largest_of(pair.force)),
                    strain = unit_of_strain(units, pair);
  Plot plot;
  plot.title = history.name;
  plot.x_label = pair.strain_name + " [" + strain.name + "]";
  plot.y_label = pair.force_name + " [" + force.name + "]";
  plot.series.push_back(
      series_of(times(strain.factor, pair.strain), times(force.factor, pair.force)));
  return plot;
}

/// Charts over time share their axis.
class TimeAxis {
public:
  /// @param is_real or that of a load sequence alone @param in_cycles which are never logarithmic
  TimeAxis(const std::vector<double> &time, const bool is_real, const bool in_cycles)
      : name(is_real ? "time" : "time of the load sequence") {
    double shortest = time.back(), longest = 0.;
    for (std::size_t i = 1; i < time.size(); ++i)
      if (const double length = time[i] - time[i - 1]; length > 0.) {
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
      }
    is_log = !in_cycles && longest > decades * shortest;
    in_hours = time.back() > long_in_seconds;
  }

  Plot plot(const std::string &y_label) const {
    Plot plot;
    plot.log_x = is_log;
    plot.x_label = name + (in_hours ? " [h]" : " [s]");
    plot.y_label = y_label;
    return plot;
  }
  double unit() const { return in_hours ? 1. / 3600. : 1.; }

private:
  const std::string name;
  bool is_log = false, in_hours = false;
};

Plot strain_over_time(const std::vector<SectionHistory> &histories, const TimeAxis &axis,
                      double SectionState::*const strain, const std::string &name) {
  Plot plot = axis.plot(name + " [%]");
  for (const SectionHistory &history : histories) {
    std::vector<double> values;
    for (const SectionState &state : history.states)
      values.push_back(100. * (state.*strain));
    plot.series.push_back(series_of(times(axis.unit(), history.time), values));
    plot.series.back().label = history.name;
  }
  return plot;
}

/// What does most work in each section.
Plot force_over_time(const UnitSystem &units, const std::vector<SectionHistory> &histories,
                     const TimeAxis &axis) {
  const auto greatest_pair = [](const SectionHistory &history) {
    return working_pairs(history).front();
  };
  const Pair first = greatest_pair(histories.front());
  const DisplayUnit unit = display_unit(units, first.force_unit, largest_of(first.force));
  Plot plot = axis.plot(first.force_name + " [" + unit.name + "]");
  for (const SectionHistory &history : histories)
    if (const Pair pair = greatest_pair(history); pair.force_name == first.force_name) {
      plot.series.push_back(
          series_of(times(axis.unit(), history.time), times(unit.factor, pair.force)));
      plot.series.back().label = history.name;
    }
  return plot;
}

} // namespace

std::vector<Plot> section_charts(const Results &results) {
  std::vector<Plot> plots;
  const std::vector<SectionHistory> &histories = results.section_histories;
  if (histories.empty() || histories.front().time.size() < 2)
    return plots;
  bool yields = false, creeps = false;
  for (const SectionHistory &history : histories) {
    for (const Pair &pair : working_pairs(history))
      plots.push_back(force_over_strain(results.units, history, pair));
    for (const SectionState &state : history.states) { // steps may have gone back to others
      yields = yields || state.plastic_strain > 0.;
      creeps = creeps || state.creep_strain > 0.;
    }
  }
  const bool in_cycles = std::any_of(results.steps.begin(), results.steps.end(),
                                     [](const StepReport &step) { return step.cycle.has_value(); });
  const TimeAxis axis(histories.front().time, creeps || !results.integrator.empty(), in_cycles);
  if (histories.front().time.back() <= 0.)
    return plots;
  if (yields)
    plots.push_back(
        strain_over_time(histories, axis, &SectionState::plastic_strain, "plastic strain"));
  if (creeps)
    plots.push_back(strain_over_time(histories, axis, &SectionState::creep_strain, "creep strain"));
  if (creeps || in_cycles)
    plots.push_back(force_over_time(results.units, histories, axis));
  return plots;
}

std::vector<Plot> cycle_charts(const Results &results) {
  std::vector<Plot> plots;
  for (const StepReport &step : results.steps) {
    if (!step.cycle)
      continue;
    if (step.cycle->number == 1 || plots.empty()) {
      Plot plot;
      plot.title = "cycles to the end of step " + step.step;
      plot.x_label = "cycle";
      plot.y_label = "in a cycle [%]";
      plot.series.resize(2);
      plot.series[0].label = "largest growth of strain";
      plot.series[1].label = "of accumulated plastic and creep strain";
      for (Plot::Series &series : plot.series)
        series.style = Plot::Series::Style::line_points;
      plots.push_back(plot);
    }
    Plot &plot = plots.back();
    for (unsigned int i = 0; i < 2; ++i) {
      plot.series[i].x.push_back(step.cycle->number);
      plot.series[i].y.push_back(100. * (i == 0 ? step.cycle->growth : step.cycle->flow));
    }
  }
  return plots;
}

} // namespace frictionbeam
