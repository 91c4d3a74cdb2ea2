// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/combination/uplift.h"

#include "results/file/csv_writer.h"
#include "results/file/output_file.h"
#include "results/frame/frame_choice.h"
#include "results/page/html.h"
#include "results/report/limits.h"
#include "results/text.h"
#include "scene/steps/step_tree.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double no_gap = 1e-9;   ///< of the line's motion
constexpr double no_force = 1e-9; ///< of the largest, in a sum of cases
constexpr std::size_t most_cases = 12;

void add_step(const Results &results, const Frame &frame, std::vector<Uplift> &all) {
  const double touching = no_gap * largest_motion(frame);
  for (unsigned int i = 0; i < frame.supports.size(); ++i)
    if (holds_up(results.supports[i]))
      all.push_back({i, frame.name, frame.supports[i].fn, stands_off(frame.supports[i], touching)});
}

void add_sum(const Results &results, const Frame &frame, std::vector<Uplift> &all) {
  const Frame *least = &frame;
  for (const CombinationRange &range : results.combination_ranges)
    if (range.step == frame.step)
      least = &range.least;
  double largest = 0.;
  for (const SupportState &state : least->supports)
    largest = std::max(largest, std::abs(state.fn));
  for (unsigned int i = 0; i < least->supports.size(); ++i)
    if (holds_up(results.supports[i])) {
      const double fn = least->supports[i].fn;
      all.push_back({i, frame.name, fn, !(fn >= -no_force * largest)});
    }
}

} // namespace

std::vector<Uplift> uplifts_of(const Scene &scene, const Results &results) {
  std::vector<Uplift> all;
  for (const Frame &frame : results.frames)
    if (frame.end_of_step && frame.step < scene.steps.size() &&
        !scene.steps[frame.step].transient && !scene.steps[frame.step].loads.empty())
      add_step(results, frame, all);
  for (const Combination &combination : scene.combinations)
    if (combination.kind == Combination::Kind::sum && is_state(scene, combination.name))
      for (const Frame &frame : results.frames)
        if (frame.name == combination.name)
          add_sum(results, frame, all);
  return all;
}

std::string uplift_table(const Scene &scene, const Results &results) {
  const std::vector<Uplift> all = uplifts_of(scene, results);
  if (all.empty())
    return "";
  std::vector<std::string> cases;
  std::vector<unsigned int> rows;
  Largest largest;
  for (const Uplift &one : all) {
    if (std::count(cases.begin(), cases.end(), one.case_name) == 0)
      cases.push_back(one.case_name);
    if (std::count(rows.begin(), rows.end(), one.support) == 0 && rows.size() < n_rows_at_most)
      rows.push_back(one.support);
    largest(one.least);
  }
  const std::size_t n_cases = cases.size();
  if (n_cases > most_cases)
    cases.erase(cases.begin(), cases.end() - most_cases);
  const DisplayUnit unit = display_unit(results.units, "N", largest.value());
  const unsigned int decimals = decimals_for(unit.factor * largest.value());
  std::vector<std::string> names;
  for (const unsigned int row : rows)
    names.push_back(results.supports[row].name);
  HtmlTable table(results.units);
  table.text("support", names);
  for (const std::string &one : cases) {
    std::vector<std::string> cells;
    for (const unsigned int row : rows) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const Uplift &uplift) {
        return uplift.support == row && uplift.case_name == one;
      });
      cells.push_back(found == all.end() ? dash
                      : !found->lifts
                          ? fixed_number(unit.factor * found->least, decimals)
                          : "<b style=\"color:#b00020\">" +
                                fixed_number(unit.factor * found->least, decimals) + " lifts</b>");
    }
    table.right_html(one, cells);
  }
  return table.str() +
         html_note("Normal force that is left in " + unit.name +
                   ", at rests and rods, at the end of static steps and in sums of one state and "
                   "what adds to it with either sign, as operating - quake." +
                   (n_cases > cases.size() || rows.size() == n_rows_at_most ? " uplift.csv has all."
                                                                            : ""));
}

void write_uplift(const Scene &scene, const Results &results, const std::string &folder) {
  const std::vector<Uplift> all = uplifts_of(scene, results);
  if (all.empty())
    return;
  std::string text = "support,case,fn,lifts\n";
  for (const Uplift &one : all)
    text += csv_field(results.supports[one.support].name) + ',' + csv_field(one.case_name) + ',' +
            exact_number(one.least / scene.units.factor("N")) + ',' + (one.lifts ? "yes" : "no") +
            '\n';
  write_file(folder + "/uplift.csv", text);
}

} // namespace frictionbeam
