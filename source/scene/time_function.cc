// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/time_function.h"

#include "base/user_error.h"
#include "scene/file/parameter_reader.h"
#include "scene/file/table_rows.h"

#include <deal.II/base/function_parser.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <mutex>
#include <sstream>

namespace frictionbeam {

const char *const time_function_form =
    "an expression in t [s], 'table t value, t value, ...', or 'file NAME' with two columns";

namespace {

using Table = std::vector<std::pair<double, double>>;

double interpolate(const Table &table, const double time) {
  const auto after = std::upper_bound(
      table.begin(), table.end(), time,
      [](const double t, const std::pair<double, double> &row) { return t < row.first; });
  if (after == table.begin())
    return 0.;
  const auto before = after - 1;
  if (after == table.end())
    return before->second;
  const double part = (time - before->first) / (after->first - before->first);
  return before->second + part * (after->second - before->second);
}

TimeFunction from_table(const ParameterReader &in, const std::string &entry, const Table &table) {
  if (table.empty())
    in.fail(entry, "at least one instant with its value", "'table 0 0, 1 1'");
  TimeFunction function;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (i > 0 && table[i].first < table[i - 1].first)
      in.fail(entry, "instants in ascending order", "sorting the table",
              "t = " + to_text(table[i].first) + " after t = " + to_text(table[i - 1].first));
    if (function.breaks.empty() || table[i].first > function.breaks.back())
      function.breaks.push_back(table[i].first);
  }
  function.begins = table.front().first;
  const auto shared = std::make_shared<const Table>(table);
  function.course = [shared](const double time) { return interpolate(*shared, time); };
  return function;
}

TimeFunction from_file(const ParameterReader &in, const std::string &entry,
                       const std::string &name) {
  namespace fs = std::filesystem;
  const fs::path beside = fs::path(in.file().name()).parent_path() / name;
  const fs::path path = fs::exists(beside) ? beside : fs::path(name);
  if (!std::ifstream(path))
    in.fail(
        entry, "a file that can be read, from the parameter file's folder or the working folder",
        "the path from " + fs::absolute(in.file().name()).parent_path().string(), "'" + name + "'");
  Table table;
  for (const TableRow &row : read_table_rows(path.string())) {
    const std::vector<std::string> fields = fields_of_row(row.text);
    double time, value;
    if (fields.size() != 2 || !to_number(fields[0], time) || !to_number(fields[1], value))
      in.fail(entry, "a file with two numbers in each line, time and value", "correcting this line",
              "'" + tidy(row.text) + "' in " + name);
    table.emplace_back(time, value);
  }
  return from_table(in, entry, table);
}

/// What deal.II writes to the standard error of a formula that it cannot read, before it throws.
/// One thread at a time: a study reads a scene in each.
class HeldBack {
public:
  HeldBack() : alone(one_at_a_time()), before(std::cerr.rdbuf(text.rdbuf())) {}
  ~HeldBack() { std::cerr.rdbuf(before); }
  HeldBack(const HeldBack &) = delete;

  /// muParser's message, in parentheses; empty where it has none.
  std::string reason() const {
    const std::string all = text.str(), head = "Message:  <";
    const std::size_t begin = all.find(head), end = all.find(">\n", begin);
    if (begin == std::string::npos || end == std::string::npos)
      return "";
    return " (" + all.substr(begin + head.size(), end - begin - head.size()) + ')';
  }

private:
  static std::mutex &one_at_a_time() {
    static std::mutex mutex;
    return mutex;
  }

  const std::lock_guard<std::mutex> alone;
  std::ostringstream text;
  std::streambuf *before;
};

} // namespace

double TimeFunction::operator()(const double time) const {
  constexpr double smallest =
      1e-150; // whose square, as work is, is a number: the tail of exp() is none
  const double value = course ? course(time) : 1.;
  if (std::abs(value) < smallest)
    return 0.;
  if (!std::isfinite(value))
    throw UserError("The history '" + text + "' is not finite at t = " + to_text(time) +
                    " s. Give one that is a number at all times of its steps.");
  return value;
}

namespace {

/// The first and the last of the breaks that are @p time, to rounding and within @p reach, or the
/// time itself. A comparison t > a has two: a, where t < a ends, and the next number.
std::pair<double, double> breaks_at(const std::vector<double> &breaks, const double time,
                                    const double reach) {
  const double near = reach + 1e-10 * std::abs(time) + 1e-15;
  const auto first = std::lower_bound(breaks.begin(), breaks.end(), time - near),
             end = std::upper_bound(first, breaks.end(), time + near);
  if (first == end)
    return {std::nan(""), time};
  return {*first, *(end - 1)};
}

} // namespace

double TimeFunction::before(const double time, const double reach) const {
  const double first = breaks_at(breaks, time, reach).first;
  return (*this)(std::isnan(first) ? time
                                   : std::nextafter(first, -std::numeric_limits<double>::max()));
}

double TimeFunction::after(const double time, const double reach) const {
  return (*this)(breaks_at(breaks, time, reach).second);
}

TimeFunction parse_time_function(const ParameterReader &in, const std::string &entry,
                                 const std::string &text, const double unit) {
  TimeFunction function;
  if (text.empty())
    return function;
  const std::vector<std::string> words = split(text, ' ');
  if (words[0] == "file" && words.size() == 2)
    function = from_file(in, entry, words[1]);
  else if (words[0] == "table") {
    Table table;
    for (const std::string &row : split(text.substr(text.find("table") + 5), ',')) {
      const std::vector<std::string> pair = split(row, ' ');
      double time, value;
      if (pair.size() != 2 || !to_number(pair[0], time) || !to_number(pair[1], value))
        in.fail(entry, time_function_form, "'table 0 0, 0.1 1'", "'" + row + "'");
      table.emplace_back(time, value);
    }
    function = from_table(in, entry, table);
  } else {
    const auto parser = std::make_shared<dealii::FunctionParser<1>>(1);
    const HeldBack said;
    try {
      parser->initialize("t", text, {{"pi", 3.14159265358979323846}});
      parser->value(dealii::Point<1>(0.));
    } catch (const dealii::ExceptionBase &) {
      in.fail(entry, time_function_form, "a formula such as '0.1*sin(2*pi*5*t)'",
              "'" + text + "'" + said.reason());
    }
    function.course = [parser](const double time) { return parser->value(dealii::Point<1>(time)); };
  }
  function.text = text;
  if (unit != 1.)
    function.course = [course = function.course, unit](const double time) {
      return unit * course(time);
    };
  return function;
}

} // namespace frictionbeam
