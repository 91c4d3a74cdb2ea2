// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/spectra/curve_file.h"

#include "base/user_error.h"
#include "scene/file/parameter_file.h"
#include "scene/file/parameter_reader.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace frictionbeam {

const char *const acceleration_units = "g, m/s2, cm/s2, mm/s2, in/s2, ft/s2";

double acceleration_unit(const std::string &name) {
  for (const auto &[word, value] : {std::pair("g", standard_gravity), std::pair("m/s2", 1.),
                                    std::pair("cm/s2", 0.01), std::pair("mm/s2", 0.001),
                                    std::pair("in/s2", 0.0254), std::pair("ft/s2", 0.3048)})
    if (name == word)
      return value;
  return 0.;
}

namespace {

[[noreturn]] void refuse(const std::string &where, const std::string &read,
                         const std::string &allowed, const std::string &hint) {
  throw UserError(where + ":\n  read:    " + read + "\n  allowed: " + allowed + "\n  try:     " +
                  hint);
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

void read_header(const std::string &line, const std::string &axes, const std::string &where,
                 Columns &columns) {
  const auto comma = line.find_first_of(",;\t");
  const std::string allowed = "a header of two columns, " + axes +
                              " and 'acceleration [UNIT]' with one of " + acceleration_units +
                              ", or none",
                    hint = "'" + axes.substr(1, axes.find('\'', 1) - 1) + ", acceleration [g]'";
  if (comma == std::string::npos)
    refuse(where, "'" + line + "'", allowed, hint);
  columns.axis = tidy(line.substr(0, comma));
  const std::string second = tidy(line.substr(comma + 1));
  columns.unit = unit_in(second);
  if (axes.find("'" + columns.axis + "'") == std::string::npos ||
      second.rfind("acceleration", 0) != 0 || acceleration_unit(columns.unit) == 0.)
    refuse(where, "'" + line + "'", allowed, hint);
}

Columns read_columns(const std::string &path, const std::string &axes, const std::string &where) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    refuse(where, "'" + path + "'", "a file that can be read", "another path");
  const std::string name = std::filesystem::path(path).filename().string();
  Columns columns;
  unsigned int number = 0;
  bool is_first = true;
  for (std::string line; std::getline(file, line);) {
    ++number;
    const std::string place = name + ":" + std::to_string(number),
                      content = tidy(line.substr(0, line.find('#')));
    if (content.empty())
      continue;
    std::string blank = content;
    for (char &c : blank)
      c = c == ',' || c == ';' || c == '\t' || c == '\r' ? ' ' : c;
    const std::vector<std::string> words = split(tidy(blank), ' ');
    double first, second;
    if (words.size() == 2 && to_number(words[0], first) && to_number(words[1], second)) {
      columns.numbers.points.emplace_back(first, second);
      columns.numbers.places.push_back(place);
    } else if (is_first && !to_number(words[0], first))
      read_header(content, axes, where + " (" + place + ")", columns);
    else
      refuse(where + " (" + place + ")", "'" + content + "'",
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
                    allowed = form.over_period ? "periods [s] that rise, and accelerations >= 0"
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
