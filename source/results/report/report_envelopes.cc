// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/file/envelope_tables.h"
#include "results/page/html.h"
#include "results/report/limits.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace frictionbeam {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN(); // shown as a dash

/// Two columns, values and their instants.
class Pair {
public:
  void add(const bool is_known, const double value, const double time) {
    values.push_back(is_known ? value : unknown);
    times.push_back(is_known ? time : unknown);
  }
  void largest(const Extremes &of) { add(of.is_known(), of.largest, of.largest_at); }
  void least(const Extremes &of) { add(of.is_known(), of.least, of.least_at); }
  void extreme(const Extremes &of) { add(of.is_known(), of.extreme(), of.extreme_at()); }

  void put(HtmlTable &table, const std::string &header, const std::string &unit,
           const double like = 0.) const {
    table.numbers(header, unit, values, like).numbers("at", "s", times);
  }
  double size() const {
    Largest result;
    for (const double value : values)
      result(value);
    return result.value();
  }

private:
  std::vector<double> values, times;
};

/// Six extremes of each row, the value of larger size.
void add_six(HtmlTable &table, const std::array<const char *, 6> &headers, const char *const first,
             const char *const second, const std::array<Pair, 6> &columns) {
  std::array<double, 2> like{};
  for (unsigned int c = 0; c < 6; ++c)
    like[c / 3] = std::max(like[c / 3], columns[c].size());
  for (unsigned int c = 0; c < 6; ++c)
    columns[c].put(table, headers[c], c < 3 ? first : second, like[c / 3]);
}

} // namespace

std::vector<std::size_t> rows_to_show(const std::vector<double> &weight) {
  std::vector<std::size_t> rows(weight.size());
  std::iota(rows.begin(), rows.end(), std::size_t(0));
  if (rows.size() > n_rows_at_most) {
    std::stable_sort(rows.begin(), rows.end(), [&](const std::size_t a, const std::size_t b) {
      return weight[a] > weight[b];
    });
    rows.resize(n_rows_at_most);
    std::sort(rows.begin(), rows.end());
  }
  return rows;
}

std::string instants_of(const StepEnvelope &envelope) {
  std::string text = "Largest values over " + std::to_string(envelope.n_instants) +
                     " instants from " + rounded_number(envelope.start) + " to " +
                     rounded_number(envelope.end) + " s, " +
                     (envelope.is_of_whole_motion ? "and over the motion between them."
                                                  : "every time step counted.");
  if (envelope.n_line_instants < envelope.n_instants)
    text += " Section forces and displacements are known at " +
            std::to_string(envelope.n_line_instants) + " of them.";
  return text;
}

std::string support_envelope_table(const Results &results, const StepEnvelope &envelope) {
  std::vector<double> weight;
  for (const SupportEnvelope &support : envelope.supports)
    weight.push_back(support.force.largest);
  std::vector<std::string> names, kinds, impacts, notes;
  Pair most, least, friction, gap, slip1, slip2, impact;
  std::vector<double> impulse;
  bool any_impact = false;
  for (const std::size_t row : rows_to_show(weight)) {
    const SupportEnvelope &support = envelope.supports[row];
    names.push_back(results.supports[row].name);
    kinds.push_back(results.supports[row].kind);
    most.largest(support.values[0]);
    least.least(support.values[0]);
    friction.largest(support.friction);
    gap.largest(support.values[3]);
    slip1.extreme(support.values[4]);
    slip2.extreme(support.values[5]);
    impulse.push_back(support.impulse);
    impact.largest(support.impact);
    impacts.push_back(std::to_string(support.n_impacts));
    notes.push_back(support.n_impacts > 0
                        ? "rigid, impact: no peak force; give a stiffness or see impulse"
                        : "");
    any_impact = any_impact || support.n_impacts > 0;
  }
  HtmlTable table(results.units);
  table.text("support", names).text("kind", kinds);
  const double force = std::max({most.size(), least.size(), friction.size()}),
               length = std::max({gap.size(), slip1.size(), slip2.size()});
  most.put(table, "largest fn", "N", force);
  least.put(table, "least fn", "N", force);
  friction.put(table, "largest |ft|", "N", force);
  gap.put(table, "largest gap", "m", length);
  slip1.put(table, "slip1", "m", length);
  slip2.put(table, "slip2", "m", length);
  table.numbers("impulse", "N s", impulse);
  std::string note = instants_of(envelope) + " Of slip, the value of larger size.";
  if (any_impact) {
    table.right("impacts", impacts);
    impact.put(table, "largest impact", "N s");
    table.text("note", notes);
    note += " A rigid support that is struck has an impulse, but no force at that instant: what a "
            "time step gives is the impulse over its length, and is left out here. Give the "
            "support a stiffness, or see the impulse.";
  }
  return table.str() + html_note(note);
}

std::string reaction_envelope_table(const Results &results, const StepEnvelope &envelope) {
  std::vector<double> weight;
  for (const RestraintEnvelope &restraint : envelope.restraints)
    weight.push_back(restraint.force.largest);
  std::vector<std::string> names, kinds;
  std::array<Pair, 6> columns;
  for (const std::size_t row : rows_to_show(weight)) {
    names.push_back(results.restraints[row].name);
    kinds.push_back(results.restraints[row].kind);
    for (unsigned int c = 0; c < 6; ++c)
      columns[c].extreme(envelope.restraints[row].values[c]);
  }
  HtmlTable table(results.units);
  table.text("restraint", names).text("kind", kinds);
  add_six(table, {{"fx", "fy", "fz", "mx", "my", "mz"}}, "N", "N m", columns);
  return table.str() + html_note(instants_of(envelope) +
                                 " Each number is the value of largest size, with its sign and "
                                 "instant; envelope.csv has both signs.");
}

std::string displacement_envelope_table(const Results &results, const StepEnvelope &envelope) {
  std::vector<std::string> names;
  std::array<Pair, 6> columns;
  for (std::size_t i = 0; i < envelope.points.size() && i < n_rows_at_most; ++i) {
    names.push_back(results.points[i].name);
    for (unsigned int c = 0; c < 6; ++c)
      columns[c].extreme(envelope.points[i][c]);
  }
  HtmlTable table(results.units);
  table.text("point", names);
  add_six(table, {{"ux", "uy", "uz", "rx", "ry", "rz"}}, "m", "rad", columns);
  return table.str() + html_note(instants_of(envelope) +
                                 " Each number is the value of largest size, with its sign and "
                                 "instant; envelope.csv has both signs.");
}

} // namespace frictionbeam
