// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/report/report.h"
#include "results/combination/uplift.h"
#include "results/file/output_file.h"
#include "results/file/summary.h"
#include "results/frame/frame_choice.h"
#include "results/how_well_known.h"
#include "results/inelastic/yield_report.h"
#include "results/listing/compliance.h"
#include "results/listing/hangers.h"
#include "results/listing/model_echo.h"
#include "results/listing/summary_in_words.h"
#include "results/page/html.h"
#include "results/picture/displacement_scale.h"
#include "results/picture/line_picture.h"
#include "results/remarks.h"
#include "results/report/report_charts.h"
#include "results/report/report_modes.h"
#include "results/report/report_study.h"
#include "results/report/report_tables.h"
#include "results/report/report_tree.h"
#include "results/stress/stresses.h"
#include "results/stress/wall_stress_table.h"
#include "results/text.h"
#include "results/turnable/model_section.h"
#include "results/verdicts.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace frictionbeam {

namespace {

constexpr unsigned int n_curves_at_most = 6;    ///< of a chart
constexpr std::size_t n_input_at_most = 200000; ///< characters

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm local{};
  char text[64] = "";
  if (localtime_r(&time, &local) != nullptr)
    std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M %Z", &local);
  return text;
}

/// Whether every step was solved, however well.
bool came_to_its_end(const Results &results) {
  return !results.steps.empty() &&
         std::all_of(results.steps.begin(), results.steps.end(),
                     [](const StepReport &step) { return step.converged; });
}

std::string accuracy_in_words(const Results &results) {
  const AccuracyAccount &account = *results.accuracy;
  return (std::isnan(account.estimate) ? "not known" : rounded_number(account.estimate, 2)) + ", " +
         rounded_number(account.demanded, 2) + " is demanded.";
}

std::string status_box(const Results &results) {
  std::string word, sentence;
  const bool fails = any_fails(results.verdicts);
  switch (results.status) {
  case RunStatus::converged:
    word = fails ? "\u26a0 Converged, and not all is well" : "\u2713 Converged";
    sentence = "Every step of the load sequence came to its end. Displacements are known to: load "
               "increments " +
               in_words(results.known.increments) + ", time step " +
               in_words(results.known.time_step) + ", cells " + in_words(results.known.cells) + ".";
    if (results.accuracy && !std::isnan(results.accuracy->estimate))
      sentence +=
          " The quantities" +
          std::string(results.accuracy->left_out.empty() ? "" : ", but for what is left out,") +
          " are estimated to be known to " + accuracy_in_words(results);
    break;
  case RunStatus::no_equilibrium:
    word = "\u26a0 No equilibrium";
    sentence = "The supports cannot hold the line under these loads: it slides or moves away." +
               where_it_stopped(results);
    break;
  case RunStatus::failed:
    word = "\u2717 Failed";
    sentence = "The solver did not come to the end of the load sequence. What follows is what it "
               "reached." +
               where_it_stopped(results);
    if (results.accuracy && !results.accuracy->reached && came_to_its_end(results)) {
      word = "\u2717 Accuracy not reached";
      sentence = "Every step of the load sequence came to its end, and the quantities are not "
                 "known to what is demanded: their error is estimated as " +
                 accuracy_in_words(results);
    }
    break;
  }
  if (results.status == RunStatus::converged && fails)
    sentence = failures_in_words(results.verdicts) + " " + sentence;
  const std::string look =
      results.status == RunStatus::converged && fails ? "checks_fail" : status_word(results.status);
  return "<div class=\"status " + look + "\"><b>" + word + "</b>" + escape_xml(sentence) +
         "</div>\n";
}

/// What was checked, each with a link to where there is more.
std::string verdict_table(const Scene &scene, const Results &results) {
  if (results.verdicts.empty())
    return "";
  std::string rows;
  const auto number = [&](const double value, const Verdict &verdict) {
    if (verdict.unit.empty() || verdict.unit == "-" || !std::isfinite(value))
      return optional_number(value, 4);
    const DisplayUnit unit =
        display_unit(scene.units, verdict.unit, std::abs(verdict.allowed.value_or(value)));
    return rounded_number(unit.factor * value + 0., 4) + " " + unit.name; // + 0.: no -0
  };
  for (const Verdict &verdict : results.verdicts)
    rows += std::string("<tr") + (verdict.passes ? "" : " class=\"fails\"") + "><td>" +
            (verdict.passes ? "\u2713 passes" : "\u2717 fails") + "</td><td><a href=\"#" +
            verdict.section + "\">" + escape_xml(verdict.check) + "</a></td><td class=\"wrap\">" +
            escape_xml(verdict.of) + "</td><td>" +
            (verdict.step.empty() ? dash : escape_xml(verdict.step)) + "</td><td class=\"r\">" +
            number(verdict.value, verdict) + "</td><td class=\"r\">" +
            (verdict.allowed ? number(*verdict.allowed, verdict) : dash) + "</td></tr>\n";
  return "<div class=\"scroll verdicts\"><table><thead><tr><th></th><th>check</th><th>of</th>"
         "<th>step or case</th><th>value</th><th>allowed</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string heading(const Scene &scene, const Results &results) {
  const bool has_title = !scene.title.empty();
  std::string text = "<h1>" + escape_xml(has_title ? scene.title : scene.name) + "</h1>\n";
  text += "<p class=\"facts\">";
  const auto fact = [&](const std::string &what) {
    text += what.empty() ? "" : "<span>" + escape_xml(what) + "</span>";
  };
  fact(has_title ? scene.name : "");
  fact(results.method);
  fact("FrictionBeam " + program_version() + " with deal.II " + deal_ii_version());
  fact(now());
  text += "</p>\n" + status_box(results) + verdict_table(scene, results);
  const auto remarks = all_remarks(scene, results);
  if (!remarks.empty()) {
    text += "<div class=\"remarks\"><b>Remarks</b><ul>\n";
    for (const auto &remark : remarks)
      text += "<li>" + escape_xml(remark) + "</li>\n";
    text += "</ul></div>\n";
  }
  return text;
}

std::string pictures(const Scene &scene, const Results &results,
                     const std::vector<const Frame *> &frames, const double scale) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const Frame *frame : frames)
    panels.emplace_back(frame->name,
                        "<div class=\"picture\">" +
                            draw_line(scene, results, *frame, frame->is_amplitude ? 0. : scale) +
                            "</div>\n");
  const bool any_amplitude = std::any_of(frames.begin(), frames.end(),
                                         [](const Frame *frame) { return frame->is_amplitude; });
  return html_tabs("line-of", panels) +
         (results.envelopes.empty()
              ? ""
              : html_note("Of a transient step the line is shown as it is at the step's end.")) +
         (any_amplitude
              ? html_note("Cases of sizes, which may have either sign, and of numbers from "
                          "different cases are no shapes: their line is drawn as it is "
                          "built.")
              : "");
}

std::string input(const Scene &scene) {
  std::string text;
  if (!scene.overrides.empty()) {
    text += "<p>Set on the command line:</p>\n<pre>";
    for (const auto &override_text : scene.overrides)
      text += escape_xml(override_text) + "\n";
    text += "</pre>\n<p>The file:</p>\n";
  }
  text += "<pre>" + escape_xml(scene.input.substr(0, n_input_at_most)) + "</pre>\n";
  if (scene.input.size() > n_input_at_most)
    text += html_note("The rest of the file is left out here.");
  return text;
}

} // namespace

void write_report(const Scene &scene, const Results &results, const std::string &folder) {
  const auto frames = frames_of_report(scene, results);
  const double scale = displacement_scale(frames);

  std::string links, sections;
  const auto add = [&](const std::string &id, const std::string &title, const std::string &body) {
    links += "<a href=\"#" + id + "\">" + escape_xml(title) + "</a>";
    sections += html_section(id, title, body);
  };
  if (!results.quantities.empty())
    add("quantities", "Quantities", quantity_table(results));
  if (results.accuracy)
    add("accuracy", "Accuracy", accuracy_section(*results.accuracy));
  if (!frames.empty()) {
    std::string steps = step_tree(scene) + step_table(scene, results, frames);
    const std::size_t n_ends = std::count_if(results.frames.begin(), results.frames.end(),
                                             [](const Frame &frame) { return frame.end_of_step; });
    if (n_ends > frames.size())
      steps += html_note("Shown here and below are " + std::to_string(frames.size()) + " of " +
                         std::to_string(n_ends) + " steps; the csv files have all of them.");
    add("steps", "Steps", steps);
    if (!frames.back()->line.empty()) { // a scene may have no pipe at all
      if (!frames.front()->line.empty())
        add("model", "Model", model_section(scene, results, frames, scale));
      add("line", "Line", pictures(scene, results, frames, scale));
    }
    const std::vector<const Frame *> in_charts = few_of(frames, n_curves_at_most);
    const ReportCharts charts = make_report_charts(scene, results, in_charts);
    if (!charts.section_forces.empty())
      add("forces", "Section forces",
          charts.section_forces +
              (in_charts.size() == frames.size()
                   ? ""
                   : html_note("Curves of " + std::to_string(in_charts.size()) + " of the " +
                               std::to_string(frames.size()) +
                               " steps and cases that this page shows: 'Output/Steps' names those "
                               "to be drawn, line.csv has all.")));
    if (!charts.histories.empty())
      add("histories", "Histories", charts.histories);
    if (const std::string flow = yield_section(scene, results); !flow.empty()) {
      add("yield", "Yield and creep", flow);
      write_file(folder + "/sections.svg",
                 "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + draw_flow(scene, results));
    }
    if (!results.supports.empty())
      if (const std::string states = state_table(results); !states.empty())
        add("states", "States", states);
    if (!results.supports.empty())
      add("supports", "Supports", support_tables(results, frames));
    if (const std::string left = uplift_table(scene, results); !left.empty())
      add("uplift", "Uplift", left);
    if (!results.restraints.empty())
      add("reactions", "Reactions", reaction_tables(results, frames));
    if (!results.points.empty())
      add("displacements", "Displacements", displacement_tables(results, frames));
    if (!results.stresses.empty())
      add("stresses", "Stresses",
          stress_section(scene, results) + compliance_section(scene, results));
    if (const std::string walls = wall_stress_section(scene, results); !walls.empty())
      add("walls", "Stresses of the wall", walls);
    if (!results.nozzles.empty())
      add("nozzles", "Allowable loads", nozzle_section(results));
    if (!results.hangers.empty())
      add("hangers", "Hangers", hanger_section(results));
    if (!results.friction_study.multipliers.empty())
      add("friction", "Friction study", friction_study_section(results));
    if (!results.supports.empty() || !results.restraints.empty())
      add("restraints", "Restraint summary", restraint_summary(results));
    if (!results.modes.empty())
      add("modes", "Modes", mode_section(scene, results));
    write_file(folder + "/line.svg", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
                                         draw_line(scene, results, *frames.back(), scale));
  }
  for (const ReportSection &section : results.sections)
    add(section.id, section.title, section.html);
  add("solver", "Solver", solver_tables(results));
  if (const std::string echo = model_echo(scene, results); !echo.empty())
    add("echo", "Nodes and elements", echo);
  add("input", "Input", input(scene));
  write_file(folder + "/report.html",
             html_page(scene.title.empty() ? scene.name : scene.title,
                       heading(scene, results) + "<nav>" + links + "</nav>\n" + sections));
}

} // namespace frictionbeam
