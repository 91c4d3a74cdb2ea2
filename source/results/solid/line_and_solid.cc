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
#include <set>

namespace frictionbeam {

namespace {

/// What is smaller is rounding, and shown as zero: of the largest force of either model, or of what
/// it would take to strain the pipe as much as it moves.
constexpr double rounding = 1e-8, rounding_of_strains = 1e-10;

/// One number of a holder or a section, by either model.
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

/// Whether a point is so near to a support that a patch of its width, which takes up the section's
/// forces bit by bit, may lie there.
bool is_on_patch(const Scene &scene, const Results &results, const Point3 &point) {
  double half = 0.;
  for (const FrictionSupport &support : scene.supports)
    half = std::max(half, support.width / 2.);
  for (const Pipe &pipe : scene.pipes)
    half = std::max(half, scene.sections[pipe.section].outer_radius);
  return std::any_of(
      results.supports.begin(), results.supports.end(),
      [&](const SupportInfo &support) { return support.position.distance(point) <= half; });
}

/// Forces of the sections at named points, on either side of those where they jump.
std::vector<Compared> compare_sections(const Scene &scene, const Results &results,
                                       const Frame &line, const Frame &solid) {
  const auto at = [](const Frame &frame, const unsigned int pipe, const unsigned int vertex) {
    std::vector<const Station *> found;
    for (const Station &one : frame.line)
      if (one.pipe == pipe && one.is_node() && one.vertex == vertex)
        found.push_back(&one);
    return found;
  };
  constexpr std::array<const char *, 6> components = {{"N", "Vy", "Vz", "Mx", "My", "Mz"}};
  std::set<std::pair<unsigned int, unsigned int>> done; // pipe and vertex, of several names
  std::vector<Compared> rows;
  for (const Station &station : solid.line) { // along the pipes
    if (!station.is_node() || !done.insert({station.pipe, station.vertex}).second)
      continue;
    const auto point =
        std::find_if(results.points.begin(), results.points.end(),
                     [&](const PointInfo &one) { return one.vertex == station.vertex; });
    const auto a = at(line, station.pipe, station.vertex),
               b = at(solid, station.pipe, station.vertex);
    if (point == results.points.end() || a.empty() || is_on_patch(scene, results, point->position))
      continue;
    const bool two = std::max(a.size(), b.size()) > 1;
    for (const bool behind : {false, true}) {
      if (behind && !two)
        continue;
      const Station &of_line = behind ? *a.back() : *a.front(),
                    &of_solid = behind ? *b.back() : *b.front();
      for (unsigned int c = 0; c < 6; ++c)
        rows.push_back({point->name + (!two     ? ""
                                       : behind ? ", after"
                                                : ", before"),
                        components[c], c < 3 ? "N" : "N m", of_line.force[c], of_solid.force[c]});
    }
  }
  return rows;
}

/// Longest edge of a box along the axes that holds points [m].
double extent_of(const std::vector<Point3> &points) {
  double longest = 0.;
  for (unsigned int d = 0; d < 3; ++d) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(),
                            [&](const Point3 &a, const Point3 &b) { return a[d] < b[d]; });
    longest = std::max(longest, low == points.end() ? 0. : (*high)[d] - (*low)[d]);
  }
  return longest;
}

/// What is nothing beside the forces and moments of a step.
struct Nothing {
  double force = 0., moment = 0.; ///< [N], [N m]

  double operator()(const std::string &unit) const { return unit == "N" ? force : moment; }
};

/// By the largest force and moment of either model, a moment being a force on the line's extent and
/// the other way round.
Nothing nothing_beside(const Scene &scene, const std::vector<Compared> &rows, const Frame &line,
                       const Frame &solid) {
  Largest force, moment, motion;
  for (const Compared &row : rows)
    for (const double value : {row.line, row.solid})
      (row.unit == "N" ? force : moment)(value);
  std::vector<Point3> places;
  for (const Frame *const frame : {&line, &solid})
    for (const Station &at : frame->line) {
      places.push_back(at.position);
      for (unsigned int c = 0; c < 6; ++c)
        (c < 3 ? force : moment)(at.force[c]);
      for (unsigned int c = 0; c < 3; ++c)
        motion(at.displacement[c]);
    }
  const double extent = extent_of(places);
  double stiffness = 0.; // E A
  for (const Pipe &pipe : scene.pipes)
    stiffness = std::max(stiffness, scene.materials[pipe.material].youngs_modulus *
                                        scene.sections[pipe.section].area);
  Nothing nothing;
  nothing.force = std::max({rounding * force.value(), rounding * moment.value() / extent,
                            rounding_of_strains * stiffness * motion.value() / extent});
  nothing.moment = nothing.force * extent;
  return nothing;
}

std::string table_of(const Scene &scene, const std::vector<Compared> &rows, const Nothing &nothing,
                     const std::string &heading) {
  Largest force, moment;
  for (const Compared &row : rows)
    for (const double value : {row.line, row.solid})
      (row.unit == "N" ? force : moment)(value);
  std::vector<std::string> what, component, a, b, difference;
  for (const Compared &row : rows) {
    const double largest = (row.unit == "N" ? force : moment).value(),
                 factor = scene.units.factor(row.unit);
    what.push_back(row.what);
    component.push_back(row.component + " [" + scene.units.name(row.unit) + "]");
    const auto shown = [&](const double value, const double unit, const unsigned int digits) {
      return std::abs(value) > nothing(row.unit) ? rounded_number(value / unit, digits) : "0";
    };
    a.push_back(shown(row.line, factor, 5));
    b.push_back(shown(row.solid, factor, 5));
    difference.push_back(
        largest > nothing(row.unit) ? shown(row.solid - row.line, 0.01 * largest, 2) + " %" : dash);
  }
  return HtmlTable()
      .text(heading, what)
      .text("", component)
      .right("Line", a)
      .right("Solid", b)
      .right("Difference", difference)
      .str();
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
  const std::vector<Compared> holders = compare_holders(results, line, solid),
                              sections = compare_sections(scene, results, line, solid);
  const Nothing nothing = nothing_beside(scene, holders, line, solid);
  const double no_force = nothing.force / N, no_moment = nothing.moment / Nm;
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
  return table_of(scene, holders, nothing, "Support") +
         table_of(scene, sections, nothing, "Section at") +
         html_note(
             "Differences relative to the largest force, or moment, of either model in the "
             "table. Section forces in the local axes of the pipe; none at supports with a patch, "
             "within which a solid's change.") +
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

std::map<std::string, double> rounding_of_forces(const Scene &scene, const Results &line,
                                                 const Results &solid) {
  std::map<std::string, double> least;
  for (const LoadStep &step : scene.steps) {
    const Frame *const a = end_of(line, step.name), *const b = end_of(solid, step.name);
    if (a == nullptr || b == nullptr)
      continue;
    const Nothing nothing = nothing_beside(scene, compare_holders(line, *a, *b), *a, *b);
    for (const char *const unit : {"N", "N m"}) {
      const auto known = least.emplace(scene.units.name(unit), nothing(unit)).first;
      known->second = std::max(known->second, nothing(unit));
    }
  }
  for (const char *const unit : {"N", "N m"})
    if (const auto known = least.find(scene.units.name(unit)); known != least.end())
      known->second /= scene.units.factor(unit);
  return least;
}

void write_line_and_solid(const Scene &scene, const Results &line, const Results &solid,
                          const std::string &folder) {
  OutputFile file(folder + "/models.csv");
  file.stream() << "what,step,component,line,solid\n";
  for (const LoadStep &step : scene.steps) {
    const Frame *const a = end_of(line, step.name), *const b = end_of(solid, step.name);
    if (a == nullptr || b == nullptr)
      continue;
    std::vector<Compared> rows = compare_holders(line, *a, *b);
    for (const Compared &row : compare_sections(scene, line, *a, *b))
      rows.push_back(row);
    for (const Compared &row : rows)
      file.stream() << csv_field(row.what) << ',' << csv_field(step.name) << ',' << row.component
                    << ',' << exact_number(row.line / scene.units.factor(row.unit)) << ','
                    << exact_number(row.solid / scene.units.factor(row.unit)) << '\n';
  }
  file.flush();
}

} // namespace frictionbeam
