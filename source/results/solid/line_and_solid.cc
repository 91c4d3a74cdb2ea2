// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/solid/line_and_solid.h"
#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/page/plot.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace frictionbeam {

namespace {

/// Of the largest force or moment of either model: what is smaller is rounding, and shown as zero.
constexpr double rounding = 1e-8;

/// One number of one holder, by either model.
struct Compared {
  std::string what, component, unit; ///< unit: SI
  double line = 0., solid = 0.;
};

const Frame *end_of(const Results &results, const std::string &step) {
  const auto found =
      std::find_if(results.frames.begin(), results.frames.end(),
                   [&](const Frame &frame) { return frame.end_of_step && frame.name == step; });
  return found == results.frames.end() ? nullptr : &*found;
}

std::vector<Compared> compare_holders(const Results &results, const Frame &line,
                                      const Frame &solid) {
  std::vector<Compared> rows;
  for (unsigned int i = 0; i < results.supports.size(); ++i) {
    const SupportState &a = line.supports[i], &b = solid.supports[i];
    const std::string &name = results.supports[i].name;
    rows.push_back({name, "fn", "N", a.fn, b.fn});
    rows.push_back({name, "ft1", "N", a.ft1, b.ft1});
    rows.push_back({name, "ft2", "N", a.ft2, b.ft2});
  }
  constexpr std::array<const char *, 6> components = {{"fx", "fy", "fz", "mx", "my", "mz"}};
  for (unsigned int i = 0; i < results.restraints.size(); ++i)
    for (unsigned int c = 0; c < 6; ++c)
      rows.push_back({results.restraints[i].name, components[c], c < 3 ? "N" : "N m",
                      line.reactions[i][c], solid.reactions[i][c]});
  return rows;
}

std::string holder_table(const Scene &scene, const Results &results, const Frame &line,
                         const Frame &solid) {
  const std::vector<Compared> rows = compare_holders(results, line, solid);
  double force = 0., moment = 0.;
  for (const Compared &row : rows)
    (row.unit == "N" ? force : moment) =
        std::max({row.unit == "N" ? force : moment, std::abs(row.line), std::abs(row.solid)});
  std::vector<std::string> what, component, a, b, difference;
  for (const Compared &row : rows) {
    const double largest = row.unit == "N" ? force : moment, factor = scene.units.factor(row.unit);
    what.push_back(row.what);
    component.push_back(row.component + " [" + scene.units.name(row.unit) + "]");
    const auto shown = [&](const double value, const double unit, const unsigned int digits) {
      return std::abs(value) > rounding * largest ? rounded_number(value / unit, digits) : "0";
    };
    a.push_back(shown(row.line, factor, 5));
    b.push_back(shown(row.solid, factor, 5));
    difference.push_back(largest > 0. ? shown(row.solid - row.line, 0.01 * largest, 2) + " %"
                                      : dash);
  }
  return HtmlTable()
             .text("Support", what)
             .text("", component)
             .right("Line", a)
             .right("Solid", b)
             .right("Difference", difference)
             .str() +
         html_note("Differences relative to the largest force, or moment, of either model.");
}

/// A number along the pipes by either model. @param least what is smaller is drawn as zero
Plot both_plot(const Scene &scene, const Frame &line, const Frame &solid, const std::string &label,
               const std::function<double(const Station &)> &number, const double least) {
  std::vector<double> start(scene.pipes.size() + 1, 0.);
  for (const Station &station : line.line)
    start[station.pipe + 1] = std::max(start[station.pipe + 1], station.s);
  for (std::size_t p = 0; p < scene.pipes.size(); ++p)
    start[p + 1] += start[p];
  Plot plot;
  plot.x_label = "s along the pipes [" + scene.units.name("m") + "]";
  plot.y_label = label;
  for (const bool is_solid : {false, true}) {
    Plot::Series series;
    series.label = is_solid ? "solid" : "line";
    series.style = is_solid ? Plot::Series::Style::points : Plot::Series::Style::line;
    for (const Station &station : (is_solid ? solid : line).line) {
      series.x.push_back((start[station.pipe] + station.s) / scene.units.factor("m"));
      const double value = number(station);
      series.y.push_back(std::abs(value) > least ? value : 0.);
    }
    plot.series.push_back(series);
  }
  return plot;
}

std::string step_panel(const Scene &scene, const Results &results, const Frame &line,
                       const Frame &solid) {
  const double m = scene.units.factor("m"), N = scene.units.factor("N"),
               Nm = scene.units.factor("N m");
  const std::string of_length = " [" + scene.units.name("m") + "]",
                    of_force = " [" + scene.units.name("N") + "]",
                    of_moment = " [" + scene.units.name("N m") + "]";
  Largest force, moment;
  for (const Frame *const frame : {&line, &solid})
    for (const Station &at : frame->line)
      for (unsigned int c = 0; c < 6; ++c)
        (c < 3 ? force : moment)(at.force[c]);
  const double no_force = rounding * force.value() / N, no_moment = rounding * moment.value() / Nm;
  std::vector<Plot> plots;
  plots.push_back(both_plot(
      scene, line, solid, "displacement" + of_length,
      [&](const Station &at) {
        return std::sqrt(at.displacement[0] * at.displacement[0] +
                         at.displacement[1] * at.displacement[1] +
                         at.displacement[2] * at.displacement[2]) /
               m;
      },
      0.));
  plots.push_back(both_plot(
      scene, line, solid, "N" + of_force, [&](const Station &at) { return at.force[0] / N; },
      no_force));
  plots.push_back(both_plot(
      scene, line, solid, "bending moment" + of_moment,
      [&](const Station &at) { return std::hypot(at.force[4], at.force[5]) / Nm; }, no_moment));
  plots.push_back(both_plot(
      scene, line, solid, "torsion" + of_moment,
      [&](const Station &at) { return at.force[3] / Nm; }, no_moment));
  return holder_table(scene, results, line, solid) +
         html_of_plots(plots, "both" + std::to_string(line.step));
}

} // namespace

std::string line_and_solid(const Scene &scene, const Results &line, const Results &solid) {
  constexpr std::size_t most = 8;
  std::vector<std::pair<std::string, std::string>> panels;
  for (const LoadStep &step : scene.steps) {
    const Frame *const a = end_of(line, step.name), *const b = end_of(solid, step.name);
    if (a != nullptr && b != nullptr && panels.size() < most)
      panels.emplace_back(step.name, step_panel(scene, line, *a, *b));
  }
  return panels.empty() ? "" : html_tabs("both", panels);
}

void write_line_and_solid(const Scene &scene, const Results &line, const Results &solid,
                          const std::string &folder) {
  OutputFile file(folder + "/models.csv");
  file.stream() << "what,step,component,line,solid\n";
  for (const LoadStep &step : scene.steps) {
    const Frame *const a = end_of(line, step.name), *const b = end_of(solid, step.name);
    if (a == nullptr || b == nullptr)
      continue;
    for (const Compared &row : compare_holders(line, *a, *b))
      file.stream() << csv_field(row.what) << ',' << csv_field(step.name) << ',' << row.component
                    << ',' << exact_number(row.line / scene.units.factor(row.unit)) << ','
                    << exact_number(row.solid / scene.units.factor(row.unit)) << '\n';
  }
  file.flush();
}

} // namespace frictionbeam
