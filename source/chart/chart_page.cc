// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chart/chart_page.h"

#include "chart/work_precision.h"

#include "results/file/output_file.h"
#include "results/page/plot.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <sstream>

namespace frictionbeam::chart {

namespace {

constexpr double rounding = 1e-16; ///< where an error of zero is drawn

double y_of(const Measurement &one) { return std::max(one.error, rounding); }

/// The measurements that no other one beats in both time and error, as a broad band.
Plot::Series front_band(const std::vector<Measurement> &measurements,
                        const std::vector<std::size_t> &front) {
  Plot::Series band;
  band.label = "efficient front";
  band.colour = "#d8d8d8";
  band.line_width = 11.;
  for (const std::size_t i : front) {
    band.x.push_back(measurements[i].median());
    band.y.push_back(y_of(measurements[i]));
  }
  return band;
}

/// The measurements of a curve, and those without an answer, above all others.
/// @param highest error of all
void add_curve(const ChartList &list, const std::vector<Measurement> &measurements,
               const std::size_t c, const double highest, Plot &plot) {
  Plot::Series series, failed;
  series.label = list.curves[c].label;
  series.style = Plot::Series::Style::line_points;
  series.colour = failed.colour = series_colour(c);
  series.marker = c % 6 + 1;
  series.point_size = 0.9;
  series.dashed = c >= 6;
  failed.label = list.curves[c].label + ": no answer";
  failed.style = Plot::Series::Style::points;
  failed.marker = 7;
  failed.point_size = 0.8;
  for (const Measurement &one : measurements)
    if (one.curve == c && one.solved()) {
      series.x.push_back(one.median());
      series.y.push_back(y_of(one));
    } else if (one.curve == c && !one.seconds.empty()) {
      failed.x.push_back(one.median());
      failed.y.push_back(3. * highest);
    }
  for (const Plot::Series &one : {series, failed})
    if (!one.x.empty())
      plot.series.push_back(one);
}

Plot make_plot(const ChartList &list, const std::vector<Measurement> &measurements) {
  Plot plot;
  plot.title = list.title;
  plot.x_label = list.time == ChartList::Time::solution  ? "time to solution [s]"
                 : list.time == ChartList::Time::process ? "time of the whole process [s]"
                                                         : "processor time of the process [s]";
  plot.y_label = "largest error of the quantities";
  plot.log_x = plot.log_y = true;
  plot.x_format = "%g";
  plot.key = Plot::Key::right;
  plot.width = 900;
  plot.height = 520;
  const std::vector<std::size_t> front = efficient_front(measurements);
  plot.series.push_back(front_band(measurements, front));
  double highest = 0.;
  for (const Measurement &one : measurements)
    if (one.solved())
      highest = std::max(highest, y_of(one));
  for (std::size_t c = 0; c < list.curves.size(); ++c)
    add_curve(list, measurements, c, highest, plot);
  for (const std::size_t i : front)
    plot.labels.push_back(
        {measurements[i].median(), y_of(measurements[i]), measurements[i].setting});
  return plot;
}

std::string csv_text(const std::string &text) {
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? "\"\"" : c == '\n' ? " " : std::string(1, c);
  return quoted + '"';
}

void write_csv(const ChartList &list, const std::vector<Measurement> &measurements,
               const std::set<std::size_t> &front, const std::string &path) {
  std::vector<std::string> names;
  for (const Measurement &one : measurements)
    for (const Value &value : one.values)
      if (std::count(names.begin(), names.end(), value.name) == 0)
        names.push_back(value.name);
  std::ostringstream out;
  out << "curve,setting,problem,error,worst_quantity,seconds_median,seconds_min,seconds_max,runs,"
         "process_seconds,peak_memory_mb,unknowns,efficient";
  for (const std::string &name : names)
    out << ',' << csv_text(name) << ',' << csv_text(name + "_reference");
  out << '\n';
  const auto number = [](const double value) {
    return std::isfinite(value) ? exact_number(value) : "";
  };
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    const Measurement &one = measurements[i];
    out << csv_text(list.curves[one.curve].label) << ',' << csv_text(one.setting) << ','
        << csv_text(one.problem) << ',' << number(one.error) << ',' << csv_text(one.worst) << ','
        << number(one.median()) << ',' << (one.seconds.empty() ? "" : number(one.seconds.front()))
        << ',' << (one.seconds.empty() ? "" : number(one.seconds.back())) << ','
        << one.seconds.size() << ',' << number(one.process_seconds) << ','
        << number(one.peak_memory_mb) << ',' << one.unknowns << ',' << front.count(i);
    for (const std::string &name : names) {
      const auto value = std::find_if(one.values.begin(), one.values.end(),
                                      [&](const Value &v) { return v.name == name; });
      out << ',' << (value == one.values.end() ? "" : number(value->value)) << ','
          << (value == one.values.end() ? "" : number(*value->reference));
    }
    out << '\n';
  }
  write_file(path, out.str());
}

/// The cheapest configuration for each decade of accuracy.
void write_choices(const ChartList &list, const std::vector<Measurement> &measurements,
                   std::ostream &out) {
  out << "| error at most | cheapest configuration | time | its error |\n| --- | --- | --- | --- "
         "|\n";
  for (int decade = 1; decade <= 8; ++decade) {
    const double accuracy = std::pow(10., -decade);
    out << "| 1e-" << decade << " | ";
    if (const auto found = cheapest(measurements, accuracy * (1. + 1e-12)))
      out << name_of(list, measurements[*found]) << " | "
          << readable_time(measurements[*found].median()) << " | "
          << rounded_number(measurements[*found].error, 2) << " |\n";
    else
      out << "none of these | | |\n";
  }
}

void write_runs(const ChartList &list, const std::vector<Measurement> &measurements,
                const std::set<std::size_t> &front, std::ostream &out) {
  out << "| configuration | error | of | time | memory | unknowns |\n"
         "| --- | --- | --- | --- | --- | --- |\n";
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    const Measurement &one = measurements[i];
    const std::string bold = front.count(i) > 0 ? "**" : "";
    out << "| " << bold << name_of(list, one) << bold << " | "
        << (one.solved() ? rounded_number(one.error, 2) : one.problem) << " | " << one.worst
        << " | " << readable_time(one.median()) << " | "
        << (one.peak_memory_mb > 0. ? rounded_number(one.peak_memory_mb, 3) + " MB" : "-") << " | "
        << (one.unknowns > 0 ? std::to_string(one.unknowns) : "") << " |\n";
  }
}

} // namespace

void write_chart(const ChartList &list, const std::vector<Measurement> &measurements,
                 const std::string &folder) {
  const std::vector<std::size_t> places = efficient_front(measurements);
  const std::set<std::size_t> front(places.begin(), places.end());
  const std::string path = folder + "/" + list.name;
  const DrawnPlots drawn = draw_plots({make_plot(list, measurements)}, "chart_" + list.name);
  if (drawn.problem.empty())
    write_file(path + ".svg", drawn.svg[0] + "\n");
  write_csv(list, measurements, front, path + ".csv");

  std::ostringstream out;
  out << "## " << list.title << "\n\n";
  if (!list.prose.empty())
    out << list.prose << '\n';
  out << (drawn.problem.empty() ? "![" + list.title + "](" + list.name + ".svg)\n"
                                : "There is no chart here, since " + drawn.problem + ".\n");
  if (!list.advice.empty())
    out << "\n**What to choose.** " << filled_advice(list, measurements) << '\n';
  out << '\n';
  write_choices(list, measurements, out);
  out << "\n<details><summary>All runs (the efficient ones bold); figures in <a href=\""
      << list.name << ".csv\">" << list.name << ".csv</a></summary>\n\n";
  write_runs(list, measurements, front, out);
  out << "\n</details>\n";
  write_file(path + ".md", out.str());
  if (!drawn.problem.empty())
    std::cout << "No chart is drawn, since " << drawn.problem << '\n';
}

} // namespace frictionbeam::chart
