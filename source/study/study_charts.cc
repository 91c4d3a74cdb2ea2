// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/study_charts.h"

#include "results/page/html.h"
#include "results/page/plot.h"
#include "results/report/limits.h"
#include "results/text.h"
#include "study/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frictionbeam::study {

namespace {

constexpr std::size_t most_charts = 8;

std::string drawn(const std::vector<Plot> &plots, const std::string &prefix) {
  if (plots.empty())
    return "";
  const DrawnPlots charts = draw_plots(plots, prefix);
  if (!charts.problem.empty())
    return html_note("There is no chart here, since " + charts.problem + ".");
  std::string text = "<div class=\"charts\">\n";
  for (const std::string &svg : charts.svg)
    text += "<div>" + svg + "</div>\n";
  return text + "</div>\n";
}

/// Quantities that vary, at most as many as get a chart.
std::vector<std::size_t> charted_names(const StudyResults &study) {
  std::vector<std::size_t> names;
  for (std::size_t i = 0; i < study.names.size() && names.size() < most_charts; ++i)
    if (study.names[i].of == ResultName::Of::quantity)
      if (const Spread spread = spread_of(study, i); spread.n > 1 && spread.largest > spread.least)
        names.push_back(i);
  return names;
}

std::string with_unit(const ResultName &name) {
  return name.name + (name.unit.empty() || name.unit == "-" ? "" : " [" + name.unit + "]");
}

/// The numbers of the runs that have one, with the values of a variable there.
void add_points(const StudyResults &study, const std::size_t name, const std::size_t variable,
                Plot::Series &series) {
  for (std::size_t run = 0; run < study.runs.size(); ++run)
    if (study.runs[run].outcome == Outcome::converged) {
      series.x.push_back(study.values[run][variable]);
      series.y.push_back(study.runs[run].numbers[name]);
    }
}

/// How strong an effect is, as text.
std::string text_of(const StudyResults &study, const ResultName &name, const Effect &effect) {
  if (effect.total)
    return rounded_number(effect.first->value, 2) + " / " + rounded_number(effect.total->value, 2);
  if (effect.elementary) {
    const double factor = name.of == ResultName::Of::quantity ? 1. : study.units.factor(name.unit);
    return rounded_number(effect.elementary->mean_size / factor, 3) + " \u00b1 " +
           rounded_number(effect.elementary->deviation / factor, 2);
  }
  return effect.rank_correlation ? fixed_number(*effect.rank_correlation, 2) : dash;
}

/// Results that the table has: all but forces, and of these the ones that vary most.
std::vector<const Sensitivity *> tabled(const StudyResults &study,
                                        const std::vector<Sensitivity> &effects) {
  constexpr std::size_t most_results = 12, most_forces = 6;
  std::vector<const Sensitivity *> results, forces;
  for (const Sensitivity &of : effects)
    (study.names[of.name].of == ResultName::Of::force ? forces : results).push_back(&of);
  results.resize(std::min(results.size(), most_results));
  std::vector<double> deviation(study.names.size(), 0.);
  for (const Sensitivity *const force : forces)
    deviation[force->name] = spread_of(study, force->name).deviation;
  std::stable_sort(forces.begin(), forces.end(),
                   [&](const Sensitivity *const a, const Sensitivity *const b) {
                     return deviation[a->name] > deviation[b->name];
                   });
  forces.resize(std::min(forces.size(), most_forces));
  results.insert(results.end(), forces.begin(), forces.end());
  return results;
}

/// Variables, the one with the largest effect on any result first.
std::vector<std::size_t> strongest_first(const StudyResults &study,
                                         const std::vector<const Sensitivity *> &results) {
  std::vector<double> strength(study.variables.size(), 0.);
  for (const Sensitivity *const of : results) {
    double largest = 0.;
    for (const Effect &effect : of->effects)
      largest = std::max(largest, effect.size());
    for (std::size_t i = 0; i < strength.size() && largest > 0.; ++i)
      strength[i] =
          std::max(strength[i], of->effects[i].size() / (of->effects[i].elementary ? largest : 1.));
  }
  std::vector<std::size_t> order(strength.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
    return strength[a] > strength[b];
  });
  order.resize(std::min<std::size_t>(order.size(), n_rows_at_most));
  return order;
}

std::string note_on(const StudyResults &study) {
  switch (study.settings.method) {
  case StudyMethod::sobol_indices:
    return "Sobol indices: the part of the result's variance that the variable makes alone / "
           "together with others. sensitivities.csv has their 95 % confidence.";
  case StudyMethod::morris:
    return "Morris' elementary effects: mean size \u00b1 standard deviation, in the result's unit, "
           "for the variable's whole range. A deviation as large as the size: the effect depends "
           "on the other variables, or is far from linear.";
  default:
    return "Spearman's rank correlation: 1 if the result only grows with the variable, -1 if it "
           "only falls. Sizes below " +
           fixed_number(correlation_by_chance(study.count(Outcome::converged)), 2) +
           " may be chance, in one of twenty cases.";
  }
}

} // namespace

std::string distribution_charts(const StudyResults &study) {
  std::vector<Plot> plots;
  for (const std::size_t i : charted_names(study)) {
    std::vector<double> numbers = study.column(i);
    std::sort(numbers.begin(), numbers.end());
    Plot plot;
    plot.x_label = with_unit(study.names[i]);
    plot.y_label = "part of the runs below";
    Plot::Series runs{"runs"};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      runs.x.insert(runs.x.end(), 2, numbers[k]);
      runs.y.push_back(static_cast<double>(k) / numbers.size());
      runs.y.push_back((k + 1.) / numbers.size());
    }
    Plot::Series nominal{"nominal", {study.nominal[i], study.nominal[i]}, {0., 1.}};
    nominal.dashed = true;
    plot.series = {runs, nominal};
    plots.push_back(plot);
  }
  return drawn(plots, "distribution");
}

std::string sensitivity_tables(const StudyResults &study, const std::vector<Sensitivity> &effects) {
  const std::vector<const Sensitivity *> results = tabled(study, effects);
  if (results.empty())
    return "";
  const std::vector<std::size_t> order = strongest_first(study, results);
  std::vector<std::string> variables;
  for (const std::size_t i : order)
    variables.push_back(study.variables[i]);
  HtmlTable table(study.units);
  table.text("variable", variables);
  for (const Sensitivity *const of : results) {
    std::vector<std::string> cells;
    for (const std::size_t i : order)
      cells.push_back(text_of(study, study.names[of->name], of->effects[i]));
    const ResultName &name = study.names[of->name];
    table.right(name.of == ResultName::Of::quantity ? name.name : column_name(name), cells);
  }
  return table.str() + html_note(note_on(study));
}

std::string dependence_charts(const StudyResults &study, const std::vector<Sensitivity> &effects) {
  std::vector<Plot> plots;
  const std::vector<std::size_t> names = charted_names(study);
  for (const Sensitivity &of : effects) {
    if (std::count(names.begin(), names.end(), of.name) == 0 || of.effects.empty())
      continue;
    const auto strongest =
        std::max_element(of.effects.begin(), of.effects.end(),
                         [](const Effect &a, const Effect &b) { return a.size() < b.size(); });
    const std::size_t variable = strongest - of.effects.begin();
    Plot plot;
    plot.x_label = study.variables[variable];
    plot.y_label = with_unit(study.names[of.name]);
    Plot::Series points;
    points.style = Plot::Series::Style::points;
    points.point_size = 0.4;
    add_points(study, of.name, variable, points);
    plot.series = {points};
    plots.push_back(plot);
  }
  const std::string charts = drawn(plots, "dependence");
  return charts.empty() ? ""
                        : charts + html_note("Each point is a run; the variable is the one that "
                                             "matters most for the quantity.");
}

std::string convergence_charts(const StudyResults &study) {
  const std::vector<std::size_t> parts = convergence_runs(study);
  if (parts.size() < 2)
    return "";
  std::vector<Plot> plots;
  for (const std::size_t i : charted_names(study)) {
    Plot plot;
    plot.x_label = "runs";
    plot.y_label = with_unit(study.names[i]);
    plot.log_x = true;
    for (std::size_t q = 0; q < study.settings.quantiles.size(); ++q) {
      Plot::Series series{rounded_number(100. * study.settings.quantiles[q]) + " %"};
      series.style = Plot::Series::Style::line_points;
      for (const std::size_t n : parts) {
        std::vector<double> numbers = study.column(i, n);
        if (numbers.empty())
          continue;
        std::sort(numbers.begin(), numbers.end());
        series.x.push_back(n);
        series.y.push_back(quantile(numbers, study.settings.quantiles[q]).value);
      }
      plot.series.push_back(series);
    }
    plots.push_back(plot);
  }
  return drawn(plots, "convergence") +
         html_note("Quantiles of the first so many runs. What the last doubling changes is about "
                   "what is left; spread.csv has bounds of each quantile.");
}

} // namespace frictionbeam::study
