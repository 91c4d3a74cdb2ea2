// SPDX-License-Identifier: LGPL-2.1-or-later
#include "study/study_report.h"

#include "results/file/output_file.h"
#include "results/file/summary.h"
#include "results/frame/frame_choice.h"
#include "results/page/html.h"
#include "results/picture/displacement_scale.h"
#include "results/picture/line_picture.h"
#include "results/report/limits.h"
#include "results/text.h"
#include "study/statistics.h"
#include "study/study_charts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frictionbeam::study {

namespace {

using Of = ResultName::Of;

std::string heading(const StudyResults &study, const Scene &scene) {
  const std::string title = scene.title.empty() ? scene.name : scene.title;
  const std::size_t n = study.runs.size(), solved = study.count(Outcome::converged);
  std::string text = "<h1>" + escape_xml(title) + "</h1>\n<p class=\"facts\">";
  for (const std::string &fact :
       {"study " + scene.name,
        std::string(study.settings.row().word) + ", seed " + std::to_string(study.settings.seed),
        "FrictionBeam " + program_version() + " with deal.II " + deal_ii_version()})
    text += "<span>" + escape_xml(fact) + "</span>";
  const bool all = solved == n;
  text += "</p>\n<div class=\"status " + std::string(all ? "converged" : "failed") + "\"><b>" +
          (all ? "\u2713 " : "\u26a0 ") + std::to_string(solved) + " of " + std::to_string(n) +
          " runs converged</b>" + std::to_string(study.variables.size()) +
          (study.variables.size() == 1 ? " variable" : " variables") + ", " +
          rounded_number(study.seconds, 3) + " s.</div>\n";
  text +=
      html_note("Stresses, allowable loads and limits are shown as they spread; no run is judged. "
                "The verdicts of the case as it stands are in the report of frictionbeam " +
                scene.name + ".prm, without study.");
  if (study.remarks.empty())
    return text;
  text += "<div class=\"remarks\"><b>Remarks</b><ul>\n";
  for (const std::string &remark : study.remarks)
    text += "<li>" + escape_xml(remark) + "</li>\n";
  return text + "</ul></div>\n";
}

std::string variable_table(const StudyResults &study) {
  std::vector<std::string> least, largest;
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    const auto by_value = [&](const std::size_t a, const std::size_t b) {
      return study.values[a][i] < study.values[b][i];
    };
    std::vector<std::size_t> runs(study.runs.size());
    std::iota(runs.begin(), runs.end(), std::size_t(0));
    const auto [low, high] = std::minmax_element(runs.begin(), runs.end(), by_value);
    const auto shown = [](const std::string &text) {
      double number = 0.;
      return to_number(text, number) ? rounded_number(number, 5) : text;
    };
    least.push_back(shown(study.texts[*low][i]));
    largest.push_back(shown(study.texts[*high][i]));
  }
  return HtmlTable(study.units)
      .text("variable", study.variables)
      .text("varies", study.described)
      .right("least taken", least)
      .right("largest taken", largest)
      .str();
}

/// Places in StudyResults::names of one sort.
std::vector<std::size_t> names_of(const StudyResults &study, const Of of,
                                  const std::string &step = "") {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < study.names.size(); ++i)
    if (study.names[i].of == of && (step.empty() || study.names[i].step == step))
      found.push_back(i);
  return found;
}

std::string quantile_word(const double probability) {
  return rounded_number(100. * probability) + " %";
}

/// Nominal, least, quantiles, largest: of results that have units of their own.
std::string table_in_own_units(const StudyResults &study, const std::vector<std::size_t> &names) {
  std::vector<std::string> title, unit, run;
  std::vector<std::vector<std::string>> numbers(3 + study.settings.quantiles.size());
  for (const std::size_t i : names) {
    const Spread spread = spread_of(study, i);
    const auto add = [&](const std::size_t column, const double number) {
      numbers[column].push_back(spread.n == 0 && column > 0 ? dash : rounded_number(number, 5));
    };
    title.push_back(study.names[i].name);
    unit.push_back(study.names[i].unit);
    add(0, study.nominal[i]);
    add(1, spread.least);
    for (std::size_t q = 0; q < study.settings.quantiles.size(); ++q)
      add(2 + q, spread.n == 0 ? 0. : spread.quantiles[q].value);
    add(2 + study.settings.quantiles.size(), spread.largest);
    run.push_back(std::to_string(spread.largest_run + 1));
  }
  HtmlTable table(study.units);
  table.text("", title).text("unit", unit).right("nominal", numbers[0]).right("least", numbers[1]);
  for (std::size_t q = 0; q < study.settings.quantiles.size(); ++q)
    table.right(quantile_word(study.settings.quantiles[q]), numbers[2 + q]);
  return table.right("largest", numbers.back()).right("in run", run).str();
}

/// The same of forces, the largest first.
HtmlTable force_table(const StudyResults &study, std::vector<std::size_t> &names) {
  std::vector<Spread> spreads(study.names.size());
  for (const std::size_t i : names)
    spreads[i] = spread_of(study, i);
  std::stable_sort(names.begin(), names.end(), [&](const std::size_t a, const std::size_t b) {
    return spreads[a].largest > spreads[b].largest;
  });
  names.resize(std::min<std::size_t>(names.size(), n_rows_at_most));
  const double like = names.empty() ? 0. : spreads[names.front()].largest;
  const auto column = [&](const auto &number) {
    std::vector<double> numbers;
    for (const std::size_t i : names)
      numbers.push_back(spreads[i].n == 0 ? std::nan("") : number(i));
    return numbers;
  };
  std::vector<std::string> titles;
  for (const std::size_t i : names)
    titles.push_back(study.names[i].name);
  HtmlTable table(study.units);
  table.text("support", titles)
      .numbers("nominal", "N", column([&](const std::size_t i) { return study.nominal[i]; }), like)
      .numbers("least", "N", column([&](const std::size_t i) { return spreads[i].least; }), like);
  for (std::size_t q = 0; q < study.settings.quantiles.size(); ++q)
    table.numbers(quantile_word(study.settings.quantiles[q]), "N",
                  column([&](const std::size_t i) { return spreads[i].quantiles[q].value; }), like);
  return table.numbers("largest", "N",
                       column([&](const std::size_t i) { return spreads[i].largest; }), like);
}

std::string largest_forces_section(const StudyResults &study) {
  std::vector<std::size_t> names = names_of(study, Of::force);
  HtmlTable table = force_table(study, names);
  std::vector<std::string> runs;
  for (const std::size_t i : names)
    runs.push_back(std::to_string(spread_of(study, i).largest_run + 1));
  return table.right("in run", runs).str() +
         html_note("Size of the largest force of each support over all steps of a run.");
}

/// Steps in their order.
std::vector<std::string> steps_of(const StudyResults &study) {
  std::vector<std::string> steps;
  for (const ResultName &name : study.names)
    if (!name.step.empty() && std::count(steps.begin(), steps.end(), name.step) == 0)
      steps.push_back(name.step);
  return steps;
}

/// Normal force, friction and status of the supports at the ends of steps.
std::string steps_section(const StudyResults &study) {
  constexpr std::size_t most_tabs = 6;
  std::vector<std::pair<std::string, std::string>> panels;
  std::vector<std::string> steps = steps_of(study);
  if (steps.size() > most_tabs)
    steps.erase(steps.begin(), steps.end() - most_tabs);
  for (const std::string &step : steps) {
    std::string panel;
    for (const auto &[of, title] : {std::make_pair(Of::normal, "Normal force"),
                                    std::make_pair(Of::friction, "Friction force")}) {
      std::vector<std::size_t> names = names_of(study, of, step);
      panel += "<h3>" + std::string(title) + "</h3>\n" + force_table(study, names).str();
    }
    std::vector<std::string> titles;
    std::vector<std::string> stick, slip, open, closed;
    const auto percent = [](const double part) { return rounded_number(100. * part, 3); };
    for (const std::size_t i : names_of(study, Of::status, step)) {
      const StatusShares shares = shares_of(study, i);
      titles.push_back(study.names[i].name);
      stick.push_back(percent(shares.stick));
      slip.push_back(percent(shares.slip));
      open.push_back(percent(shares.open));
      closed.push_back(percent(shares.closed));
      if (titles.size() == n_rows_at_most)
        break;
    }
    panel += "<h3>Status, % of the runs</h3>\n" + HtmlTable(study.units)
                                                      .text("support", titles)
                                                      .right("stick", stick)
                                                      .right("slip", slip)
                                                      .right("open", open)
                                                      .right("closed", closed)
                                                      .str();
    panels.emplace_back(step, panel);
  }
  return html_tabs("spread-of", panels) +
         html_note("At the ends of the steps; spread.csv has all steps and supports, and the "
                   "reactions of anchors and guides.");
}

std::string failed_section(const StudyResults &study) {
  std::vector<std::string> numbers, words, reasons;
  std::vector<std::vector<std::string>> values(study.variables.size());
  for (std::size_t run = 0; run < study.runs.size(); ++run) {
    if (study.runs[run].outcome == Outcome::converged || numbers.size() == n_rows_at_most)
      continue;
    numbers.push_back(std::to_string(run + 1));
    words.emplace_back(row_of(outcomes, study.runs[run].outcome).word);
    reasons.push_back(study.runs[run].reason);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i].push_back(study.texts[run][i]);
  }
  constexpr std::size_t most_columns = 8;
  HtmlTable table(study.units);
  table.right("run", numbers).text("outcome", words).text("why", reasons);
  for (std::size_t i = 0; i < std::min(values.size(), most_columns); ++i)
    table.right(study.variables[i], values[i]);
  return table.str() + html_note("failed.csv has all of them with all their entries.");
}

std::string line_section(const Scene &scene, const Results &nominal) {
  const auto frames = frames_to_show(nominal, 1);
  if (frames.empty() || frames.back()->line.empty())
    return "";
  return "<div class=\"picture\">" +
         draw_line(scene, nominal, *frames.back(), displacement_scale(frames)) + "</div>\n" +
         html_note("The case as it stands, at the end of its last step.");
}

} // namespace

void write_study_report(const StudyResults &study, const std::vector<Sensitivity> &effects,
                        const Scene &scene, const Results &nominal, const std::string &folder) {
  std::string links, sections;
  const auto add = [&](const std::string &id, const std::string &title, const std::string &body) {
    if (body.empty())
      return;
    links += "<a href=\"#" + id + "\">" + escape_xml(title) + "</a>";
    sections += html_section(id, title, body);
  };
  const auto in_own_units = [&](const Of of) {
    const std::vector<std::size_t> names = names_of(study, of);
    return names.empty() ? "" : table_in_own_units(study, names);
  };
  add("variables", "What varies", variable_table(study));
  add("line", "Line", line_section(scene, nominal));
  add("quantities", "Quantities", in_own_units(Of::quantity));
  add("distributions", "Distributions", distribution_charts(study));
  add("sensitivities", "What matters", sensitivity_tables(study, effects));
  add("dependence", "Dependence", dependence_charts(study, effects));
  add("forces", "Supports", largest_forces_section(study));
  add("steps", "Steps", steps_section(study));
  add("nozzles", "Allowable loads", in_own_units(Of::nozzle));
  add("stresses", "Stresses", in_own_units(Of::stress));
  add("convergence", "Convergence", convergence_charts(study));
  if (study.count(Outcome::converged) < study.runs.size())
    add("failed", "Runs without an answer", failed_section(study));
  add("input", "Input", "<pre>" + escape_xml(scene.input) + "</pre>\n");
  write_file(folder + "/report.html",
             html_page(scene.title.empty() ? scene.name : scene.title,
                       heading(study, scene) + "<nav>" + links + "</nav>\n" + sections));
}

} // namespace frictionbeam::study
