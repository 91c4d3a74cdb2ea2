// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/report/report_study.h"
#include "results/combination/governing_cases.h"
#include "results/file/csv_writer.h"
#include "results/file/envelope_tables.h"
#include "results/file/output_file.h"
#include "results/page/html.h"
#include "results/report/limits.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace frictionbeam {

namespace {

double size_of(const SupportState &s) { return std::hypot(s.fn, s.ft1, s.ft2); }
double size_of(const Motion &f) { return std::hypot(f[0], f[1], f[2]); }

/// Rows with the largest weights, falling.
std::vector<std::size_t> largest_first(const std::vector<double> &weight) {
  std::vector<std::size_t> rows(weight.size());
  std::iota(rows.begin(), rows.end(), std::size_t(0));
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const std::size_t a, const std::size_t b) { return weight[a] > weight[b]; });
  rows.resize(std::min(rows.size(), n_rows_at_most));
  return rows;
}

/// The largest force of a support over all steps, and what goes with it.
struct SummaryRow {
  std::string name, kind, step, when;
  double force = 0., normal = 0., friction = 0., moment = 0.;
  double impulse = 0., impact = 0.; ///< over the transient steps, and of one impact [N s]
  bool is_struck = false;
};

void set_support(const SupportState &state, SummaryRow &row) {
  row.normal = state.fn;
  row.friction = friction_force(state);
}

/// Take the end of a static step, or the largest of a transient one, where it is larger.
/// @param i of all supports and then all restraints
void include_step(const Frame &frame, const StepEnvelope *const envelope, const std::size_t i,
                  SummaryRow &row) {
  const bool support = i < frame.supports.size();
  const std::size_t r = i - frame.supports.size();
  Extremes force; // of a transient step
  if (envelope != nullptr)
    force = support ? envelope->supports[i].force : envelope->restraints[r].force;
  const double size = force.is_known() ? force.largest
                      : support        ? size_of(frame.supports[i])
                                       : size_of(frame.reactions[r]);
  if (envelope != nullptr && support && envelope->supports[i].n_impacts > 0) {
    row.is_struck = true;
    row.impulse += envelope->supports[i].impulse;
    row.impact = std::max(row.impact, envelope->supports[i].impact.largest);
  }
  if (size <= row.force && !row.step.empty())
    return;
  row.force = size;
  row.step = frame.name;
  row.when = force.is_known() ? rounded_number(force.largest_at, 5) : "end";
  if (support) {
    set_support(force.is_known() ? envelope->supports[i].at_largest : frame.supports[i], row);
    return;
  }
  const Motion &f = force.is_known() ? envelope->restraints[r].at_largest : frame.reactions[r];
  row.moment = std::hypot(f[3], f[4], f[5]);
}

/// Of all supports, the one with the largest force first.
std::vector<SummaryRow> summary_rows(const Results &results) {
  std::vector<SummaryRow> all;
  for (const SupportInfo &info : results.supports)
    all.push_back({info.name, info.kind, "", ""});
  for (const RestraintInfo &info : results.restraints)
    all.push_back({info.name, info.kind, "", ""});
  for (const Frame &frame : results.frames)
    if (frame.end_of_step && frame.is_judged)
      for (std::size_t i = 0; i < all.size(); ++i)
        include_step(frame, results.envelope_of(frame.step), i, all[i]);
  std::vector<double> weight;
  for (const SummaryRow &row : all)
    weight.push_back(row.force);
  std::vector<SummaryRow> rows;
  for (const std::size_t i : largest_first(weight))
    rows.push_back(all[i]);
  return rows;
}

} // namespace

std::string restraint_summary(const Results &results) {
  const std::vector<SummaryRow> rows = summary_rows(results);
  const auto column = [&](const auto &value) {
    std::vector<decltype(value(rows.front()))> values;
    for (const SummaryRow &row : rows)
      values.push_back(value(row));
    return values;
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  HtmlTable table(results.units);
  table.text("support", column([](const SummaryRow &row) { return row.name; }))
      .text("kind", column([](const SummaryRow &row) { return row.kind; }))
      .numbers("largest force", "N", column([](const SummaryRow &row) { return row.force; }))
      .numbers("fn", "N", column([](const SummaryRow &row) { return row.normal; }))
      .numbers("friction", "N", column([](const SummaryRow &row) { return row.friction; }))
      .numbers("moment", "N m", column([](const SummaryRow &row) { return row.moment; }))
      .text("in step", column([](const SummaryRow &row) { return row.step; }));
  std::string note = "The largest force of each support over all steps, and the step that it comes "
                     "from; the worst line is the first.";
  if (std::any_of(results.frames.begin(), results.frames.end(),
                  [&](const Frame &frame) { return frame.step >= results.steps.size(); }))
    note += " The spectrum and combinations count where they are states, as for a capacity "
            "(doc/load_cases.md): differences, sums of two states and envelopes do not.";
  if (!results.envelopes.empty()) {
    table.right("at time [s]", column([](const SummaryRow &row) { return row.when; }));
    note += " Of static steps their ends count, of transient ones every time step; fn, friction "
            "and moment are those of that instant.";
  }
  if (std::any_of(rows.begin(), rows.end(), [](const SummaryRow &row) { return row.is_struck; })) {
    const auto if_struck = [&](double SummaryRow::*const value) {
      return column([&](const SummaryRow &row) { return row.is_struck ? row.*value : none; });
    };
    table.numbers("impulse", "N s", if_struck(&SummaryRow::impulse))
        .numbers("largest impact", "N s", if_struck(&SummaryRow::impact))
        .text("note", column([](const SummaryRow &row) -> std::string {
                return row.is_struck
                           ? "rigid, impact: no peak force; give a stiffness or see impulse"
                           : "";
              }));
    note += " The force of a rigid support does not exist at the instant in which it is struck: "
            "the table has its force at all other instants, its impulse over the transient steps "
            "and the largest impulse of one impact. Give it a stiffness for a force.";
  }
  return table.str() + html_note(note);
}

namespace {

/// The motion of a point that is on no pipe, in a frame of a step; null if it is not known, as of
/// cases that are made of others.
const Motion *observed(const Results &results, const std::string &point, const Frame &frame) {
  if (frame.step >= results.steps.size())
    return nullptr;
  for (const History &history : results.histories)
    if (history.point == point)
      for (std::size_t i = history.time.size(); i-- > 0;) // of two at one time, the later
        if (history.time[i] == frame.time)
          return &history.displacement[i];
  return nullptr;
}

} // namespace

std::string displacement_tables(const Results &results, const std::vector<const Frame *> &frames) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const Frame *const frame : frames) {
    std::vector<std::string> names;
    std::array<std::vector<double>, 6> motions;
    std::array<double, 2> largest{};
    for (const PointInfo &point : results.points) {
      const auto station = std::find_if(frame->line.begin(), frame->line.end(),
                                        [&](const Station &s) { return s.vertex == point.vertex; });
      const Motion *const motion = station != frame->line.end()
                                       ? &station->displacement
                                       : observed(results, point.name, *frame);
      if (motion == nullptr || names.size() == n_rows_at_most)
        continue;
      names.push_back(point.name);
      for (unsigned int c = 0; c < 6; ++c) {
        motions[c].push_back((*motion)[c]);
        largest[c / 3] = std::max(largest[c / 3], std::abs((*motion)[c]));
      }
    }
    const char *const titles[] = {"ux", "uy", "uz", "rx", "ry", "rz"};
    HtmlTable table(results.units);
    table.text("point", names);
    for (unsigned int c = 0; c < 6; ++c)
      table.numbers(titles[c], c < 3 ? "m" : "rad", motions[c], largest[c / 3]);
    const StepEnvelope *const envelope = results.envelope_of(frame->step);
    panels.emplace_back(frame->name,
                        (envelope != nullptr ? "<h3>Over the step</h3>\n" +
                                                   displacement_envelope_table(results, *envelope) +
                                                   "<h3>At its end</h3>\n"
                                             : "") +
                            table.str() + governing_point_table(results, *frame));
  }
  return html_tabs("displacements-of", panels) +
         html_note("Of the named points, in global axes; line.csv has every station.");
}

std::vector<double> largest_forces(const Results &results) {
  std::vector<double> largest(results.supports.size() + results.restraints.size(), 0.);
  for (const Frame &frame : results.frames) {
    if (!frame.is_judged)
      continue;
    for (std::size_t i = 0; i < frame.supports.size(); ++i)
      largest[i] = std::max(largest[i], size_of(frame.supports[i]));
    for (std::size_t i = 0; i < frame.reactions.size(); ++i)
      largest[results.supports.size() + i] =
          std::max(largest[results.supports.size() + i], size_of(frame.reactions[i]));
  }
  for (const StepEnvelope &envelope : results.envelopes) {
    for (std::size_t i = 0; i < envelope.supports.size(); ++i)
      largest[i] = std::max(largest[i], envelope.supports[i].force.largest);
    for (std::size_t i = 0; i < envelope.restraints.size(); ++i)
      largest[results.supports.size() + i] =
          std::max(largest[results.supports.size() + i], envelope.restraints[i].force.largest);
  }
  return largest;
}

namespace {

/// What nozzles and stresses use of what is allowed, the largest of the steps, by kind and name.
std::map<std::pair<std::string, std::string>, double> ratios_of(const Results &run) {
  std::map<std::pair<std::string, std::string>, double> ratios;
  for (const NozzleUse &one : run.nozzles) {
    double &ratio = ratios[{"nozzle", one.name + " at " + one.support}];
    ratio = std::max(ratio, one.utilization);
  }
  for (const StressCase &one : run.stresses)
    if (!one.stress.empty())
      ratios[{"stress", one.kind + " " + one.name}] =
          one.stress[one.worst] / one.allowed[one.worst];
  return ratios;
}

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

} // namespace

void include_in_study(const double multiplier, const Results &run, FrictionStudy &study) {
  const std::size_t n = study.multipliers.size();
  study.multipliers.push_back(multiplier);
  study.largest.push_back(largest_forces(run));
  for (const auto &[key, value] : ratios_of(run)) {
    auto known = std::find_if(study.ratios.begin(), study.ratios.end(),
                              [&key = key](const FrictionStudy::Ratio &ratio) {
                                return ratio.kind == key.first && ratio.of == key.second;
                              });
    if (known == study.ratios.end())
      known =
          study.ratios.insert(known, {key.first, key.second, std::vector<double>(n, not_known)});
    known->values.push_back(value);
  }
  for (FrictionStudy::Ratio &ratio : study.ratios)
    ratio.values.resize(n + 1, not_known);
}

namespace {

/// How much nozzles and stresses use, with each multiplier.
std::string ratio_table(const FrictionStudy &study) {
  if (study.ratios.empty())
    return "";
  std::vector<std::string> kinds, names, worst, at;
  for (const FrictionStudy::Ratio &ratio : study.ratios) {
    kinds.push_back(ratio.kind);
    names.push_back(ratio.of);
    std::size_t most = 0;
    for (std::size_t m = 0; m < ratio.values.size(); ++m)
      if (!(ratio.values[m] <= ratio.values[most])) // the first may not be known
        most = std::isfinite(ratio.values[m]) ? m : most;
    worst.push_back((ratio.values[most] > 1. ? "\u2717 " : "") +
                    fixed_number(100. * ratio.values[most], 1));
    at.push_back(rounded_number(study.multipliers[most]));
  }
  HtmlTable table;
  table.text("of", kinds).text("allowable", names);
  for (std::size_t m = 0; m < study.multipliers.size(); ++m) {
    std::vector<std::string> values;
    for (const FrictionStudy::Ratio &ratio : study.ratios)
      values.push_back(std::isfinite(ratio.values[m]) ? fixed_number(100. * ratio.values[m], 1)
                                                      : dash);
    table.right("friction \u00d7 " + rounded_number(study.multipliers[m]) + " [%]", values);
  }
  return table.right("worst [%]", worst).right("at \u00d7", at).str() +
         html_note("Largest use of allowable loads and stresses over all steps; \u2717: more than "
                   "is allowed.");
}

} // namespace

std::string friction_study_section(const Results &results) {
  const FrictionStudy &study = results.friction_study;
  std::vector<double> worst(study.names.size(), 0.);
  std::vector<std::string> at(study.names.size());
  for (std::size_t m = 0; m < study.multipliers.size(); ++m)
    for (std::size_t i = 0; i < worst.size(); ++i)
      if (study.largest[m][i] > worst[i]) {
        worst[i] = study.largest[m][i];
        at[i] = rounded_number(study.multipliers[m]);
      }
  const auto rows = largest_first(worst);
  std::vector<std::string> names, which;
  std::vector<double> most;
  for (const std::size_t i : rows) {
    names.push_back(study.names[i]);
    which.push_back(at[i]);
    most.push_back(worst[i]);
  }
  HtmlTable table(results.units);
  table.text("support", names);
  for (std::size_t m = 0; m < study.multipliers.size(); ++m) {
    std::vector<double> values;
    for (const std::size_t i : rows)
      values.push_back(study.largest[m][i]);
    table.numbers("friction \u00d7 " + rounded_number(study.multipliers[m]), "N", values,
                  most.empty() ? 0. : most.front());
  }
  return table.numbers("worst", "N", most).right("at \u00d7", which).str() +
         html_note("Largest force of each support over all steps (of transient steps at any of "
                   "their instants, blows on rigid supports left out), with all friction "
                   "coefficients multiplied; \u00d7 1 is this run. The verdicts judge this run "
                   "alone; the other runs' own results are in the folders friction_*.") +
         ratio_table(study);
}

void write_friction_study(const Results &results, const std::string &folder) {
  const FrictionStudy &study = results.friction_study;
  if (study.multipliers.empty())
    return;
  std::string text = "support";
  for (const double multiplier : study.multipliers)
    text += ",x" + exact_number(multiplier);
  text += '\n';
  for (std::size_t i = 0; i < study.names.size(); ++i) {
    text += csv_field(study.names[i]);
    for (std::size_t m = 0; m < study.multipliers.size(); ++m)
      text += ',' + exact_number(study.largest[m][i] / results.units.factor("N"));
    text += '\n';
  }
  write_file(folder + "/friction_study.csv", text);
  if (study.ratios.empty())
    return;
  text = "of,allowable";
  for (const double multiplier : study.multipliers)
    text += ",x" + exact_number(multiplier);
  text += '\n';
  for (const FrictionStudy::Ratio &ratio : study.ratios) {
    text += ratio.kind + ',' + csv_field(ratio.of);
    for (const double value : ratio.values)
      text += ',' + (std::isfinite(value) ? exact_number(value) : std::string());
    text += '\n';
  }
  write_file(folder + "/friction_study_ratios.csv", text);
}

} // namespace frictionbeam
