// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/inelastic/yield_report.h"

#include "results/inelastic/section_charts.h"
#include "results/inelastic/yielding.h"
#include "results/page/html.h"
#include "results/picture/coloured_line.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {

constexpr std::size_t n_utilizations_at_most = 4; ///< pictures of it, by steps
constexpr std::size_t n_hinges_at_most = 100;

std::string percent(const double part) { return rounded_number(100. * part, 3); }

/// Of the sections of a pipe, at a place along it: straight between two sections; NaN where it has
/// none. Of two at one place, the larger.
double interpolated(const std::vector<SectionState> &sections, double SectionState::*const value,
                    const unsigned int pipe, const double s) {
  const auto begin = std::find_if(sections.begin(), sections.end(),
                                  [&](const SectionState &one) { return one.pipe == pipe; });
  const auto end = std::find_if(begin, sections.end(),
                                [&](const SectionState &one) { return one.pipe != pipe; });
  if (begin == end)
    return std::numeric_limits<double>::quiet_NaN();
  const auto after = std::lower_bound(
      begin, end, s, [](const SectionState &one, const double place) { return one.s < place; });
  if (after == end)
    return (*std::prev(after)).*value;
  double result = (*after).*value;
  if (after->s == s)
    for (auto same = after; same != end && same->s == s; ++same)
      result = std::max(result, (*same).*value);
  else if (after != begin) {
    const SectionState &before = *std::prev(after);
    const double part = (s - before.s) / (after->s - before.s);
    result = (1. - part) * before.*value + part * result;
  }
  return result;
}

std::size_t nearest_station(const Frame &frame, const SectionState &section) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < frame.line.size(); ++i)
    if (const double distance = std::abs(frame.line[i].s - section.s);
        frame.line[i].pipe == section.pipe && distance < least) {
      least = distance;
      nearest = i;
    }
  return nearest;
}

double largest(const Frame &frame, double SectionState::*const value) {
  double result = 0.;
  for (const SectionState &section : frame.sections)
    result = std::max(result, section.*value);
  return result;
}

std::string draw(const Scene &scene, const Results &results, const Frame &frame,
                 double SectionState::*const value, const std::string &name) {
  ColouredLine what;
  what.title = name + (frame.name == over_all_steps ? ", " : ", end of step ") + frame.name;
  for (const Station &station : frame.line)
    what.values.push_back(interpolated(frame.sections, value, station.pipe, station.s));
  const bool is_utilization = value == &SectionState::utilization;
  const double most = largest(frame, value);
  what.largest = is_utilization ? std::max(1., most) : most > 0. ? most : 1.;
  what.legend = name + ", 0 to " + percent(what.largest) + " %";
  if (!is_utilization) {
    for (const Hinge &hinge : hinges_of({&frame}))
      what.rings.push_back({nearest_station(frame, hinge.worst),
                            "hinge, plastic strain " + percent(hinge.worst.plastic_strain) + " %"});
    what.ring_meaning = "hinges";
  }
  return draw_coloured_line(scene, results, frame, what);
}

std::string pictures(const Scene &scene, const Results &results,
                     const std::vector<const Frame *> &frames) {
  std::vector<std::pair<std::string, std::string>> panels;
  const auto add = [&](const Frame &frame, double SectionState::*const value,
                       const std::string &name) {
    panels.emplace_back(name + ", " + frame.name, "<div class=\"picture\">" +
                                                      draw(scene, results, frame, value, name) +
                                                      "</div>\n");
  };
  const std::size_t n = std::min(frames.size(), n_utilizations_at_most);
  for (std::size_t i = 0; i < n; ++i) // the last ones among them
    add(*frames[n == 1 ? frames.size() - 1 : i * (frames.size() - 1) / (n - 1)],
        &SectionState::utilization, "utilization");
  const Frame end = most_flowed(frames);
  const double plastic = largest(end, &SectionState::plastic_strain),
               creep = largest(end, &SectionState::creep_strain);
  if (creep > 0. && creep <= plastic)
    add(end, &SectionState::creep_strain, "creep strain");
  if (plastic > 0.)
    add(end, &SectionState::plastic_strain, "plastic strain");
  if (creep > plastic) // the larger one is in front
    add(end, &SectionState::creep_strain, "creep strain");
  return html_tabs("flow-of", panels);
}

/// Columns of a strain, where it is largest and in which step it grew most.
/// @param length of pipes [m], for all columns to be in one unit
void add_columns(HtmlTable &table, const std::string &name, const std::vector<WorstSection> &worst,
                 const std::string &step_name, const double length) {
  std::vector<std::string> values, steps;
  std::vector<double> s;
  for (const WorstSection &one : worst) {
    const bool is_any = one.value > 0.;
    values.push_back(is_any ? percent(one.value) : std::isnan(one.value) ? "not told" : "0");
    s.push_back(is_any ? one.s : std::numeric_limits<double>::quiet_NaN());
    steps.push_back(is_any ? one.step : dash);
  }
  table.right(name + " [%]", values).numbers("at s", "m", s, length).text(step_name, steps);
}

std::string pipe_table(const Scene &scene, const Results &results) {
  std::vector<std::string> names, n_hinges;
  std::vector<WorstSection> plastic, creep, utilization;
  std::vector<double> dissipated;
  bool creeps = false;
  double length = 0.;
  for (const PipeYield &pipe : yield_of_pipes(results)) {
    names.push_back(scene.pipes[pipe.pipe].name);
    plastic.push_back(pipe.plastic);
    creep.push_back(pipe.creep);
    utilization.push_back(pipe.utilization);
    dissipated.push_back(pipe.dissipated);
    n_hinges.push_back(std::to_string(pipe.n_hinges));
    creeps = creeps || pipe.creep.value > 0.;
    length = std::max({length, pipe.plastic.s, pipe.creep.s, pipe.utilization.s});
  }
  HtmlTable table(results.units);
  table.text("pipe", names);
  add_columns(table, "plastic", plastic, "mostly in", length);
  if (creeps)
    add_columns(table, "creep", creep, "mostly in", length);
  add_columns(table, "utilization", utilization, "end of", length);
  return table.numbers("dissipated", "J", dissipated).right("hinges", n_hinges).str() +
         html_note(
             "The worst section of each pipe. Plastic and creep strain are equivalent, accumulated "
             "to the end of the run, at the section's worst point, with the step in which they "
             "grew most; the utilization is equivalent stress "
             "over the yield stress that is reached by then, the largest at the ends of "
             "steps. sections.csv has every section.");
}

std::string hinge_table(const Scene &scene, const Results &results,
                        const std::vector<const Frame *> &frames) {
  const std::string definition =
      "A hinge: sections one beside the other whose plastic strain is above the strain at first "
      "yield in tension (0.2 % where the law does not tell it). A section that bends so far "
      "carries 96 % of its limit moment or more, if it is thin and does not harden.";
  std::vector<Hinge> found = hinges_of(frames);
  const std::size_t n = found.size();
  std::stable_sort(found.begin(), found.end(), [](const Hinge &a, const Hinge &b) {
    return a.worst.plastic_strain > b.worst.plastic_strain;
  });
  found.resize(std::min(n, n_hinges_at_most));
  const std::vector<SectionState> &end = frames.back()->sections;
  const bool is_told = std::none_of(end.begin(), end.end(), [](const SectionState &section) {
    return std::isnan(section.plastic_strain);
  });
  if (found.empty())
    return "<h3>Hinges</h3>\n" +
           html_note((is_told ? "None. " : "Not known: the law of a section does not tell. ") +
                     definition);
  std::vector<std::string> pipes, strain, utilization, since, flows;
  std::vector<double> from, to, at, moment;
  for (const Hinge &hinge : found) {
    pipes.push_back(scene.pipes[hinge.worst.pipe].name);
    from.push_back(hinge.from);
    to.push_back(hinge.to);
    at.push_back(hinge.worst.s);
    strain.push_back(percent(hinge.worst.plastic_strain));
    utilization.push_back(percent(hinge.worst.utilization));
    moment.push_back(std::hypot(hinge.worst.force[4], hinge.worst.force[5]));
    since.push_back(hinge.since);
    flows.push_back(hinge.flows ? "yes" : "no");
  }
  const double length = *std::max_element(to.begin(), to.end());
  HtmlTable table(results.units);
  table.text("pipe", pipes)
      .numbers("from s", "m", from, length)
      .numbers("to", "m", to, length)
      .numbers("worst at", "m", at, length)
      .right("plastic strain [%]", strain)
      .right("utilization [%]", utilization)
      .numbers("bending moment", "N m", moment)
      .text("since step", since)
      .text("flows in the last step", flows);
  return "<h3>Hinges</h3>\n" + table.str() +
         html_note(definition + (n > n_hinges_at_most
                                     ? " Shown are the worst " + std::to_string(n_hinges_at_most) +
                                           " of " + std::to_string(n) + "."
                                     : ""));
}

/// Each cycle of loads that repeat themselves.
std::string cycle_table(const Results &results) {
  std::vector<std::string> steps, numbers, growth, flow, verdicts;
  std::vector<double> dissipated;
  for (const StepReport &step : results.steps)
    if (step.cycle) {
      steps.push_back(step.step);
      numbers.push_back(std::to_string(step.cycle->number) + " of " +
                        std::to_string(step.cycle->of));
      growth.push_back(percent(step.cycle->growth));
      flow.push_back(percent(step.cycle->flow));
      dissipated.push_back(step.cycle->dissipated);
      verdicts.push_back(step.cycle->words);
    }
  if (steps.empty())
    return "";
  return "<h3>Cycles</h3>\n" +
         HtmlTable(results.units)
             .text("to the end of step", steps)
             .right("cycle", numbers)
             .right("growth of strain [%]", growth)
             .right("flow [%]", flow)
             .numbers("dissipated", "J", dissipated)
             .text("verdict so far", verdicts)
             .str() +
         html_note("The largest growth of a section's strain from beginning to end of the cycle, "
                   "and of its accumulated plastic and creep strain.") +
         html_of_plots(cycle_charts(results), "cycles");
}

std::string charts(const Results &results) {
  const std::vector<Plot> plots = section_charts(results);
  if (plots.empty())
    return "";
  const unsigned int every = results.section_histories.front().every;
  return "<h3>Sections through the run</h3>\n" + html_of_plots(plots, "section") +
         html_note((every == 1 ? std::string("Every increment")
                               : "One of " + std::to_string(every) + " increments") +
                   ", in section_history.csv as well. Moment and curvature are those about the "
                   "axis of the section's largest moment, with their signs. Output/Sections "
                   "chooses sections by points; without it they are the two that flow most.");
}

} // namespace

std::string yield_section(const Scene &scene, const Results &results) {
  const std::vector<const Frame *> frames = frames_of_sections(results);
  if (frames.empty())
    return "";
  return pipe_table(scene, results) + pictures(scene, results, frames) +
         hinge_table(scene, results, frames) + cycle_table(results) + charts(results);
}

std::string draw_flow(const Scene &scene, const Results &results) {
  const Frame end = most_flowed(frames_of_sections(results));
  const double plastic = largest(end, &SectionState::plastic_strain),
               creep = largest(end, &SectionState::creep_strain);
  if (plastic == 0. && creep == 0.)
    return draw(scene, results, end, &SectionState::utilization, "utilization");
  return creep > plastic
             ? draw(scene, results, end, &SectionState::creep_strain, "creep strain")
             : draw(scene, results, end, &SectionState::plastic_strain, "plastic strain");
}

} // namespace frictionbeam
