// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/frame_choice.h"
#include "results/page/html.h"
#include "results/picture/marker.h"
#include "results/report/limits.h"
#include "results/report/report_tables.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr unsigned int n_columns_at_most = 12;

/// How far a support has slipped, or stands off [m].
double distance(const SupportState &state) {
  return state.status == ContactStatus::open ? state.gap : std::hypot(state.slip1, state.slip2);
}

/// Whether any support of it has a status; those of sums and of numbers of either sign have none.
bool knows_a_status(const Frame &frame) {
  return std::any_of(frame.supports.begin(), frame.supports.end(),
                     [](const SupportState &state) { return state.status != ContactStatus::none; });
}

} // namespace

std::string state_table(const Results &results) {
  std::vector<const Frame *> frames;
  for (const Frame *frame : frames_to_show(results, n_columns_at_most))
    if (!frame->is_amplitude && knows_a_status(*frame))
      frames.push_back(frame);
  if (frames.size() < 2)
    return "";
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < results.supports.size(); ++i)
    rows.push_back(i);
  const auto changes = [&](const std::size_t i) {
    return std::any_of(frames.begin(), frames.end(), [&](const Frame *frame) {
      const ContactStatus status = frame->supports[i].status;
      return status != ContactStatus::none && status != frames.front()->supports[i].status;
    });
  };
  if (rows.size() > n_rows_at_most) { // those that change stay first
    std::stable_partition(rows.begin(), rows.end(), changes);
    rows.resize(n_rows_at_most);
    std::sort(rows.begin(), rows.end());
  }
  Largest largest;
  for (const Frame *frame : frames)
    for (const std::size_t row : rows)
      if (frame->supports[row].status != ContactStatus::none)
        largest(distance(frame->supports[row]));
  const DisplayUnit unit = display_unit(results.units, "m", largest.value());
  const unsigned int decimals = decimals_for(unit.factor * largest.value());
  std::vector<std::string> names;
  for (const std::size_t row : rows)
    names.push_back(results.supports[row].name);
  HtmlTable table(results.units);
  table.text("support", names);
  for (const Frame *frame : frames) {
    std::vector<std::string> cells;
    for (const std::size_t row : rows) {
      const SupportState &state = frame->supports[row];
      if (state.status == ContactStatus::none) {
        cells.push_back(dash);
        continue;
      }
      const double size = unit.factor * distance(state);
      cells.push_back(status_cell(state.status) +
                      (size > 0.5 * std::pow(10., -static_cast<int>(decimals))
                           ? " " + fixed_number(size, decimals)
                           : ""));
    }
    table.html(frame->name, cells);
  }
  std::string note = "The state of each support at the end of each step, with its slip since "
                     "contact began, or its gap where it is open, in " +
                     unit.name + ".";
  if (rows.size() < results.supports.size())
    note += " Of " + std::to_string(results.supports.size()) +
            " supports those that change and "
            "some others are shown; supports.csv has all.";
  return table.str() + html_note(note);
}

} // namespace frictionbeam
