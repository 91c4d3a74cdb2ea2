// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/spectra/curve_file.h"

#include "base/unit_constants.h"
#include "base/user_error.h"
#include "scene/file/choice.h"
#include "scene/file/parameter_file.h"
#include "scene/file/parameter_reader.h"
#include "scene/file/table_rows.h"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace frictionbeam {

namespace {

constexpr Word<double> units_of_acceleration[] = {{"g", standard_gravity}, {"m/s2", 1.},
                                                  {"cm/s2", 0.01},         {"mm/s2", 0.001},
                                                  {"in/s2", inch},         {"ft/s2", 12. * inch}};

} // namespace

double acceleration_unit(const std::string &name) {
  const auto *const found = find_word(units_of_acceleration, name);
  return found == std::end(units_of_acceleration) ? 0. : found->value;
}

std::string acceleration_units() { return join(words_of(units_of_acceleration)); }

namespace {

[[noreturn]] void refuse(const std::string &where, const std::string &read,
                         const std::string &allowed, const std::string &hint) {
  throw UserError(where + ":\n  read:    " + read + "\n  allowed: " + allowed +
                  "\n  try:     " + hint);
}

/// Two columns of a file.
struct Columns {
  WrittenCurve numbers;
  std::string axis, unit; ///< of the header: "frequency [Hz]", "g"; empty: there is none
};

/// "acceleration [g]" to its unit.
std::string unit_in(const std::string &header) {
  const auto open = header.find('['), close = header.find(']');
  return open == std::string::npos || close == std::string::npos || close < open
             ? ""
             : tidy(header.substr(open + 1, close - open - 1));
}

void read_header(const std::string &line, const std::vector<std::string> &fields,
                 const std::string &axes, const std::string &where, Columns &columns) {
  columns.axis = fields[0];
  columns.unit = fields.size() == 2 ? unit_in(fields[1]) : "";
  if (fields.size() != 2 || axes.find("'" + columns.axis + "'") == std::string::npos ||
      fields[1].rfind("acceleration", 0) != 0 || acceleration_unit(columns.unit) == 0.)
    refuse(where, "'" + line + "'",
           "a header of two columns, " + axes + " and 'acceleration [UNIT]' with one of " +
               acceleration_units() + ", or none",
           "'" + axes.substr(1, axes.find('\'', 1) - 1) + ", acceleration [g]'");
}

Columns read_columns(const std::string &path, const std::string &axes, const std::string &where) {
  if (!std::ifstream(path) || std::filesystem::is_directory(path))
    refuse(where, "'" + path + "'", "a file that can be read", "another path");
  const std::string name = std::filesystem::path(path).filename().string();
  Columns columns;
  bool is_first = true;
  for (const TableRow &row : read_table_rows(path)) {
    const std::string place = name + ":" + std::to_string(row.line);
    const std::vector<std::string> fields = fields_of_row(row.text);
    double first, second;
    if (fields.size() == 2 && to_number(fields[0], first) && to_number(fields[1], second)) {
      columns.numbers.points.emplace_back(first, second);
      columns.numbers.places.push_back(place);
    } else if (is_first && !fields.empty() &&
               std::isalpha(static_cast<unsigned char>(fields[0][0])) != 0)
      read_header(tidy(row.text), fields, axes, where + " (" + place + ")", columns);
    else
      refuse(where + " (" + place + ")", "'" + tidy(row.text) + "'",
             "two numbers in each line, with a point before the decimals",
             "correcting this line, or a # before it");
    is_first = false;
  }
  if (columns.numbers.points.empty())
    refuse(where, "no line with two numbers in '" + path + "'", "at least one",
           "'frequency [Hz], acceleration [g]' and a line for each point");
  return columns;
}

/// What the header says goes into the form; not against what the user says besides.
void apply(const Columns &columns, const std::string &where, CurveForm &form) {
  if (columns.axis.empty())
    return;
  const double unit = acceleration_unit(columns.unit);
  const bool over_period = columns.axis.rfind("period", 0) == 0;
  if (form.unit_given && std::abs(unit - form.unit) > 1e-12 * unit)
    refuse(where, "accelerations in '" + columns.unit + "' in the header of the file",
           "what the file says", "leaving the unit to the header");
  if (form.axis_given && over_period != form.over_period)
    refuse(where, "'" + columns.axis + "' in the header of the file", "what the file says",
           "leaving frequency or period to the header");
  form.over_period = over_period;
  form.unit = unit;
  form.unit_name = columns.unit;
}

} // namespace

std::vector<std::pair<double, double>> to_curve(const WrittenCurve &written, const CurveForm &form,
                                                const std::string &where) {
  const std::string axis = form.over_period ? "period" : "frequency",
                    allowed = form.over_period
                                  ? "periods [s] that rise, and accelerations >= 0"
                                  : "frequencies [Hz] that rise, and accelerations >= 0";
  std::vector<std::pair<double, double>> curve;
  for (std::size_t i = 0; i < written.points.size(); ++i) {
    const auto [x, a] = written.points[i];
    const std::string read =
        axis + " " + to_text(x) + ", acceleration " + to_text(a) + " (" + written.places[i] + ")";
    if (!(x >= 0.) || !(a >= 0.) || !std::isfinite(x) || !std::isfinite(a))
      refuse(where, read, allowed, "taking out the sign, or the point");
    if (i > 0 && x == written.points[i - 1].first)
      refuse(where, read + ", which has the " + axis + " of the point before", allowed,
             "one of the two points, or two a little apart where the curve jumps");
    if (i > 0 && x < written.points[i - 1].first)
      refuse(where, read + " behind " + axis + " " + to_text(written.points[i - 1].first), allowed,
             form.over_period ? "sorting the points by their periods"
                              : "sorting the points by their frequencies");
    curve.emplace_back(!form.over_period ? x
                       : x > 0.          ? 1. / x
                                         : std::numeric_limits<double>::infinity(),
                       a * form.unit);
  }
  if (form.over_period)
    curve = {curve.rbegin(), curve.rend()};
  return curve;
}

std::vector<std::pair<double, double>> read_curve_file(const std::string &path, CurveForm &form,
                                                       const std::string &where) {
  const Columns columns = read_columns(path, "'frequency [Hz]' or 'period [s]'", where);
  apply(columns, where, form);
  return to_curve(columns.numbers, form, where);
}

AccelerationRecord read_record_file(const std::string &path, CurveForm &form,
                                    const std::string &where) {
  const Columns columns = read_columns(path, "'time [s]'", where);
  apply(columns, where, form);
  AccelerationRecord record;
  const auto &points = columns.numbers.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [t, a] = points[i];
    const std::string read = "time " + to_text(t) + ", acceleration " + to_text(a) + " (" +
                             columns.numbers.places[i] + ")";
    if (!std::isfinite(t) || !std::isfinite(a))
      refuse(where, read, "finite numbers", "correcting this line");
    if (i > 0 && !(t > points[i - 1].first))
      refuse(where, read + " behind time " + to_text(points[i - 1].first), "instants that rise",
             "sorting the record, one acceleration an instant");
    record.time.push_back(t);
    record.acceleration.push_back(a * form.unit);
  }
  if (record.time.size() < 2)
    refuse(where, "a record of one instant", "at least two", "the whole record");
  return record;
}

} // namespace frictionbeam
