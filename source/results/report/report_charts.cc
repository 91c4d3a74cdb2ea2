// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/report/report_charts.h"
#include "results/page/html.h"
#include "results/page/plot.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frictionbeam {

namespace {

constexpr unsigned int n_pipes_at_most = 8, n_points_at_most = 8;

/// Anything smaller than this part of its like is rounding and gets no chart.
constexpr double nothing = 1e-7;

/// Charts under a heading.
struct Group {
  std::string heading, key; ///< the key is HTML
  std::vector<Plot> plots;
};

/// One key for all charts of the section forces: the colours of the steps.
std::string step_key(const std::vector<const Frame *> &frames) {
  if (frames.size() < 2)
    return "";
  std::string key = "<p class=\"key\">";
  for (unsigned int i = 0; i < frames.size(); ++i)
    key +=
        "<span style=\"--c:" + series_colour(i) + "\">" + escape_xml(frames[i]->name) + "</span>";
  return key + "</p>\n";
}

/// Least and largest section force of a transient step along a pipe, dashed.
void add_envelope(const Scene &scene, const Results &results, const StepEnvelope &envelope,
                  const unsigned int pipe, const unsigned int component, const double factor,
                  const std::string &colour, Plot &plot) {
  for (const auto *const values : {&envelope.least, &envelope.largest}) {
    Plot::Series series;
    series.dashed = true;
    series.colour = colour;
    series.line_width = 1.5;
    for (std::size_t i = 0; i < results.stations.size(); ++i)
      if (results.stations[i].pipe == pipe) {
        series.x.push_back(results.stations[i].s / scene.units.factor("m"));
        series.y.push_back(factor * (*values)[6 * i + component]);
      }
    plot.series.push_back(std::move(series));
  }
}

Group pipe_charts(const Scene &scene, const Results &results,
                  const std::vector<const Frame *> &frames, const unsigned int pipe,
                  const std::array<double, 2> &largest_of_all) {
  static const std::array<const char *, 6> names{{"N, axial force", "Vy, shear force",
                                                  "Vz, shear force", "Mx, torsional moment",
                                                  "My, bending moment", "Mz, bending moment"}};
  Group group{"Pipe " + scene.pipes[pipe].name, step_key(frames), {}};
  for (unsigned int c = 0; c < 6; ++c) {
    Largest largest;
    for (const Frame *frame : frames)
      for (const Station &station : frame->line)
        if (station.pipe == pipe)
          largest(station.force[c]);
    for (const StepEnvelope &envelope : results.envelopes)
      for (std::size_t i = 0; i < results.stations.size(); ++i)
        if (results.stations[i].pipe == pipe)
          for (const auto *const values : {&envelope.least, &envelope.largest})
            largest((*values)[6 * i + c]);
    if (largest.value() <= nothing * largest_of_all[c / 3])
      continue;
    const DisplayUnit unit = display_unit(scene.units, c < 3 ? "N" : "N m", largest.value());
    Plot plot;
    plot.x_label = "s [" + scene.units.name("m") + "]";
    plot.y_label = std::string(names[c]) + " [" + unit.name + "]";
    for (const Frame *frame : frames) {
      Plot::Series series;
      // the wider ones beneath, to be seen where steps agree
      series.line_width = 1.5 + 0.8 * (frames.size() - 1 - plot.series.size());
      series.colour = series_colour(plot.series.size());
      for (const Station &station : frame->line)
        if (station.pipe == pipe) {
          series.x.push_back(station.s / scene.units.factor("m"));
          series.y.push_back(unit.factor * station.force[c]);
        }
      plot.series.push_back(std::move(series));
    }
    for (unsigned int i = 0; i < frames.size(); ++i)
      if (const StepEnvelope *const envelope = results.envelope_of(frames[i]->step))
        add_envelope(scene, results, *envelope, pipe, c, unit.factor, series_colour(i), plot);
    group.plots.push_back(std::move(plot));
  }
  return group;
}

/// The pipes with the largest moments and forces, in the order of the scene.
std::vector<unsigned int> pipes_to_show(const Scene &scene,
                                        const std::vector<const Frame *> &frames,
                                        const std::array<double, 2> &largest_of_all) {
  std::vector<double> weight(scene.pipes.size(), 0.);
  for (const Frame *frame : frames)
    for (const Station &station : frame->line)
      for (unsigned int c = 0; c < 6; ++c)
        if (std::isfinite(station.force[c]) && largest_of_all[c / 3] > 0.)
          weight[station.pipe] =
              std::max(weight[station.pipe], std::abs(station.force[c]) / largest_of_all[c / 3]);
  std::vector<unsigned int> pipes(scene.pipes.size());
  std::iota(pipes.begin(), pipes.end(), 0u);
  if (pipes.size() > n_pipes_at_most) {
    std::stable_sort(pipes.begin(), pipes.end(), [&](const unsigned int a, const unsigned int b) {
      return weight[a] > weight[b];
    });
    pipes.resize(n_pipes_at_most);
    std::sort(pipes.begin(), pipes.end());
  }
  return pipes;
}

/// One chart of some numbers over time, in one unit; none where all of them are below @p
/// negligible.
void add_time_chart(const std::string &what, const std::string &si_unit, const bool transient,
                    const std::vector<double> &time,
                    const std::vector<std::pair<std::string, std::vector<double>>> &curves,
                    const double negligible, const UnitSystem &units, Group &group) {
  Largest largest;
  for (const auto &curve : curves)
    for (const double value : curve.second)
      largest(value);
  if (largest.value() <= negligible)
    return;
  const DisplayUnit unit = display_unit(units, si_unit, largest.value());
  Plot plot;
  plot.x_label = transient ? "time [s]" : "time of the load sequence [s]";
  plot.y_label = what + " [" + unit.name + "]";
  for (const auto &[label, values] : curves) {
    Largest largest_of_curve;
    for (const double value : values)
      largest_of_curve(value);
    if (largest_of_curve.value() <= std::max(negligible, nothing * largest.value()))
      continue;
    Plot::Series series;
    series.label = label;
    series.x = time;
    if (time.size() <= 60)
      series.style = Plot::Series::Style::line_points;
    for (const double value : values)
      series.y.push_back(unit.factor * value);
    plot.series.push_back(std::move(series));
  }
  group.plots.push_back(std::move(plot));
}

/// A chart of the translations and one of the rotations of a point. @p largest: of all points.
Group history_charts(const History &history, const bool transient,
                     const std::array<double, 2> &largest, const UnitSystem &units) {
  static const std::array<const char *, 6> names{{"ux", "uy", "uz", "rx", "ry", "rz"}};
  Group group{"Point " + history.point, "", {}};
  for (unsigned int kind = 0; kind < 2; ++kind) {
    std::vector<std::pair<std::string, std::vector<double>>> curves;
    for (unsigned int c = 3 * kind; c < 3 * kind + 3; ++c) {
      curves.emplace_back(names[c], std::vector<double>());
      for (const Motion &motion : history.displacement)
        curves.back().second.push_back(motion[c]);
    }
    add_time_chart(kind == 0 ? "displacement" : "rotation", kind == 0 ? "m" : "rad", transient,
                   history.time, curves, nothing * largest[kind], units, group);
  }
  return group;
}

/// Largest force and moment within the pipes, of frames and envelopes.
std::array<double, 2> largest_section_forces(const Results &results,
                                             const std::vector<const Frame *> &frames) {
  std::array<Largest, 2> largest;
  for (const Frame *frame : frames)
    for (const Station &station : frame->line)
      for (unsigned int c = 0; c < 6; ++c)
        largest[c / 3](station.force[c]);
  for (const StepEnvelope &envelope : results.envelopes)
    for (const auto *const values : {&envelope.least, &envelope.largest})
      for (std::size_t k = 0; k < values->size(); ++k)
        largest[k % 6 / 3]((*values)[k]);
  return {{largest[0].value(), largest[1].value()}};
}

/// Largest translation and rotation of monitored points.
std::array<double, 2> largest_motions(const Results &results) {
  std::array<Largest, 2> largest;
  for (const History &history : results.histories)
    for (const Motion &motion : history.displacement)
      for (unsigned int c = 0; c < 6; ++c)
        largest[c / 3](motion[c]);
  return {{largest[0].value(), largest[1].value()}};
}

/// A group under its heading. @param first of its plots among those drawn
std::string html_of(const Group &group, const DrawnPlots &drawn, const std::size_t first) {
  const std::string heading = "<h3>" + escape_xml(group.heading) + "</h3>\n";
  if (group.plots.empty())
    return heading + html_note("Nothing here is other than zero.");
  return heading + (drawn.problem.empty() ? group.key : "") +
         html_charts(drawn, first, group.plots.size());
}

} // namespace

ReportCharts make_report_charts(const Scene &scene, const Results &results,
                                const std::vector<const Frame *> &frames) {
  const std::array<double, 2> largest = largest_section_forces(results, frames),
                              largest_motion = largest_motions(results);
  std::vector<Group> groups;
  const auto pipes = pipes_to_show(scene, frames, largest);
  for (const unsigned int pipe : pipes)
    groups.push_back(pipe_charts(scene, results, frames, pipe, largest));
  const std::size_t n_pipe_groups = groups.size();
  const bool transient = std::any_of(scene.steps.begin(), scene.steps.end(),
                                     [](const LoadStep &step) { return step.transient; });
  for (const History &history : results.histories)
    if (history.time.size() > 1 && groups.size() < n_pipe_groups + n_points_at_most)
      groups.push_back(history_charts(history, transient, largest_motion, scene.units));

  std::vector<Plot> plots;
  for (const Group &group : groups)
    plots.insert(plots.end(), group.plots.begin(), group.plots.end());
  const DrawnPlots drawn = draw_plots(plots, "chart");

  ReportCharts charts;
  std::size_t next = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (g < n_pipe_groups && !groups[g].plots.empty())
      charts.section_forces += html_of(groups[g], drawn, next);
    else if (g >= n_pipe_groups)
      charts.histories += html_of(groups[g], drawn, next);
    next += groups[g].plots.size();
  }

  if (!results.envelopes.empty() && !charts.section_forces.empty())
    charts.section_forces += html_note("Solid: at the end of each step. Dashed: the least and the "
                                       "largest over all instants of a transient step; "
                                       "envelope.csv has them with their instants.");
  if (charts.section_forces.empty() && !pipes.empty())
    charts.section_forces = html_note("All section forces are zero.");
  if (pipes.size() < scene.pipes.size())
    charts.section_forces += html_note("Shown are the " + std::to_string(pipes.size()) +
                                       " pipes with the largest forces of " +
                                       std::to_string(scene.pipes.size()) + "; line.csv has all.");
  if (results.histories.size() > n_points_at_most)
    charts.histories +=
        html_note("Shown are the first " + std::to_string(n_points_at_most) + " points of " +
                  std::to_string(results.histories.size()) + "; the files history_*.csv have all.");
  return charts;
}

} // namespace frictionbeam
