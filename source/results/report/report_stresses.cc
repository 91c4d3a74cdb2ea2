// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/picture/coloured_line.h"
#include "results/report/limits.h"
#include "results/stress/stresses.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// The name of the point that a station stands on, or nothing.
std::string point_name(const Results &results, const Station &station) {
  for (const PointInfo &point : results.points)
    if (point.vertex == station.vertex)
      return point.name;
  return "";
}

std::string percent(const double part) { return fixed_number(100. * part, 1); }

/// When something was met, in seconds; "end" of what is known there only.
std::string instant(const std::optional<double> &time) {
  return time ? rounded_number(*time, 5) : "end";
}

/// When the stress of a station was met.
std::optional<double> instant_at(const StressCase &one, const std::size_t station) {
  return one.time.empty() ? std::optional<double>() : one.time[station];
}

const char *const of_transient_steps =
    " Of transient steps the largest over all instants counts, and the instant is given.";

/// The line, coloured by the stress over what is allowed.
std::string picture_of(const Scene &scene, const Results &results, const StressCase &one) {
  ColouredLine what;
  what.title = one.kind + ", " + one.name;
  what.largest = std::max(1., one.stress[one.worst] / one.allowed[one.worst]);
  what.legend = std::string(one.time.empty() ? "stress" : "largest stress of the step") +
                " over what is allowed, 0 to " + percent(what.largest) + " %";
  for (std::size_t i = 0; i < one.stress.size(); ++i)
    what.values.push_back(one.stress[i] / one.allowed[i]);
  return "<div class=\"picture\">" + draw_coloured_line(scene, results, one.frame, what) +
         "</div>\n";
}

} // namespace

std::string stress_section(const Scene &scene, const Results &results) {
  if (results.stresses.empty())
    return "";
  std::vector<std::string> names, kinds, pipes, points, use, when;
  std::vector<double> s, stress, allowed;
  bool any_envelope = false;
  std::vector<std::pair<std::string, std::string>> panels;
  for (const StressCase &one : results.stresses) {
    if (one.stress.empty())
      continue;
    const Station &station = one.frame.line[one.worst];
    names.push_back(one.name);
    kinds.push_back(one.kind);
    pipes.push_back(scene.pipes[station.pipe].name);
    points.push_back(point_name(results, station));
    s.push_back(station.s);
    stress.push_back(one.stress[one.worst]);
    allowed.push_back(one.allowed[one.worst]);
    use.push_back(percent(stress.back() / allowed.back()));
    when.push_back(instant(instant_at(one, one.worst)));
    any_envelope = any_envelope || !one.time.empty();
    if (panels.size() < n_pictures_at_most)
      panels.emplace_back(one.kind + " " + one.name, picture_of(scene, results, one));
  }
  HtmlTable table(results.units);
  table.text("case", names)
      .text("kind", kinds)
      .text("worst on pipe", pipes)
      .text("at", points)
      .numbers("s", "m", s)
      .numbers("stress", "Pa", stress)
      .numbers("allowed", "Pa", allowed)
      .right("used [%]", use);
  if (any_envelope)
    table.right("at time [s]", when);
  return table.str() +
         html_note("By " + results.stresses.front().code +
                   ", with nominal walls. stresses.csv has every station." +
                   (any_envelope ? of_transient_steps : "")) +
         html_tabs("stress-of", panels);
}

std::string nozzle_section(const Results &results) {
  std::vector<std::string> names, supports, steps, use, when;
  bool any_envelope = false;
  std::array<std::vector<double>, 6> force;
  for (const NozzleUse &one : results.nozzles) {
    names.push_back(one.name);
    supports.push_back(one.support);
    steps.push_back(one.step);
    use.push_back(percent(one.utilization));
    when.push_back(instant(one.time));
    any_envelope = any_envelope || one.time;
    for (unsigned int c = 0; c < 6; ++c)
      force[c].push_back(one.force[c]);
  }
  const char *const titles[] = {"fx", "fy", "fz", "mx", "my", "mz"};
  HtmlTable table(results.units);
  table.text("limit", names).text("support", supports).text("step", steps);
  for (unsigned int c = 0; c < 6; ++c)
    table.numbers(titles[c], c < 3 ? "N" : "N m", force[c]);
  table.right("used [%]", use);
  if (any_envelope)
    table.right("at time [s]", when);
  return table.str() +
         html_note(std::string("The largest ratio of a force or moment on the pipe to what is "
                               "allowed.") +
                   (any_envelope
                        ? std::string(of_transient_steps) + " The forces are those of that instant."
                        : ""));
}

void write_stresses(const Scene &scene, const Results &results, const std::string &folder) {
  const double metre = 1. / results.units.factor("m"), pascal = 1. / results.units.factor("Pa");
  const auto seconds = [](const std::optional<double> &time) {
    return time ? exact_number(*time) : std::string();
  };
  std::string text = "case,kind,pipe,s,stress,allowed,utilization,time\n";
  for (const StressCase &one : results.stresses)
    for (std::size_t i = 0; i < one.stress.size(); ++i) {
      const Station &station = one.frame.line[i];
      text +=
          csv_field(one.name) + ',' + one.kind + ',' + csv_field(scene.pipes[station.pipe].name) +
          ',' + exact_number(metre * station.s) + ',' + exact_number(pascal * one.stress[i]) + ',' +
          exact_number(pascal * one.allowed[i]) + ',' +
          exact_number(one.stress[i] / one.allowed[i]) + ',' + seconds(instant_at(one, i)) + '\n';
    }
  if (!results.stresses.empty())
    write_file(folder + "/stresses.csv", text);
  text = "limit,support,step,fx,fy,fz,mx,my,mz,utilization,time\n";
  for (const NozzleUse &one : results.nozzles) {
    text += csv_field(one.name) + ',' + csv_field(one.support) + ',' + csv_field(one.step);
    for (unsigned int c = 0; c < 6; ++c)
      text += ',' + exact_number(one.force[c] / results.units.factor(c < 3 ? "N" : "N m"));
    text += ',' + exact_number(one.utilization) + ',' + seconds(one.time) + '\n';
  }
  if (!results.nozzles.empty())
    write_file(folder + "/nozzles.csv", text);
}

} // namespace frictionbeam
