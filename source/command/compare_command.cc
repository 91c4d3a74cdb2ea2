// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/compare_command.h"

#include "base/csv_row.h"
#include "base/numbers.h"
#include "base/user_error.h"
#include "results/text.h"
#include "scene/file/parameter_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <set>

namespace frictionbeam {

namespace {

struct QuantityOfRun {
  double value = 0., in_si = 0.; ///< in_si: SI units in its unit; 0: not known
  std::string unit;
};

/// What summary.json says of a run.
struct Run {
  std::string folder, status;
  std::map<std::string, QuantityOfRun> quantities; ///< by name
  std::map<std::string, double> units; ///< how many of SI one of the tables' is, by that of SI
  /// Of the report: what fails, by check; nothing of one that passes.
  std::map<std::string, std::set<std::string>> failures;

  double in_si(const std::string &unit) const {
    const auto found = units.find(unit);
    return found == units.end() ? 1. : found->second;
  }
};

Run read_run(const std::string &folder) {
  const std::string path = folder + "/summary.json";
  std::ifstream in(path);
  const nlohmann::json summary = nlohmann::json::parse(in, nullptr, false);
  if (!in || !summary.contains("quantities"))
    throw UserError("There is no '" + path +
                    "' of this program. Name two folders with results of it: frictionbeam compare "
                    "output/a output/b");
  Run run{folder, summary.value("status", "converged"), {}, {}, {}};
  for (const nlohmann::json &quantity : summary.at("quantities")) {
    if (!quantity.at("value").is_number())
      continue;
    const auto in_si = quantity.find("in_si");
    run.quantities[quantity.at("name")] = {
        quantity.at("value").get<double>(),
        in_si != quantity.end() && in_si->is_number() ? in_si->get<double>() : 0.,
        quantity.at("unit").get<std::string>()};
  }
  if (const auto units = summary.find("units"); units != summary.end())
    for (const auto &[si, unit] : units->items())
      run.units[si] = unit.at("in_si").get<double>();
  if (const auto verdicts = summary.find("verdicts"); verdicts != summary.end())
    for (const nlohmann::json &one : *verdicts) {
      std::set<std::string> &of_check = run.failures[one.at("check")];
      const std::string of = one.at("of"), step = one.at("step");
      if (!one.at("passes").get<bool>())
        of_check.insert(of + (step.empty() ? "" : " in " + step));
    }
  return run;
}

/// A column and its unit in SI; empty: of words.
struct Column {
  std::string name, unit;
};

/// A csv file whose rows are found by their texts: names, steps, and numbers that place them.
struct Table {
  /// Numbers by column, in the units of the first run; NaN: none.
  struct Row {
    std::string status;
    std::map<std::string, double> numbers;
  };
  std::map<std::string, Row> rows;
};

/// What of a table is compared.
struct Layout {
  std::string title, file;
  std::vector<Column> keys; ///< columns that say what a row is about
  std::vector<Column> columns;
};

[[noreturn]] void refuse(const std::string &what, const std::string &path,
                         const std::string &read) {
  throw UserError(what + " of '" + path + "'.\n  read:    '" + read +
                  "'\n  allowed: the tables as this program has written them\n  try:     run the "
                  "case again");
}

/// The number in a field; NaN if it is empty.
double number_in(const std::string &field, const std::string &column, const std::string &path) {
  double number = std::numeric_limits<double>::quiet_NaN();
  if (!field.empty() && !to_number(field, number))
    refuse("There is no number in column " + column, path, field);
  return number;
}

/// @param first in whose units the numbers are
Table read_table(const Run &run, const Run &first, const Layout &layout) {
  const std::string path = run.folder + '/' + layout.file;
  std::ifstream in(path);
  Table table;
  std::string line;
  if (!in || !std::getline(in, line))
    return table;
  const auto factor = [&](const std::string &unit) { return run.in_si(unit) / first.in_si(unit); };
  const std::vector<std::string> header = csv_fields(line);
  std::map<std::string, unsigned int> seen; // a node may stand twice, with either side
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = csv_fields(line);
    if (fields.size() != header.size())
      refuse("A row has other fields than the header", path, line);
    std::map<std::string, std::string> field;
    for (std::size_t i = 0; i < header.size(); ++i)
      field[header[i]] = fields[i];
    std::string key;
    for (const auto &[name, unit] : layout.keys) {
      std::string place = field[name];
      if (!unit.empty() && !place.empty())
        place = rounded_number(number_in(place, name, path) * factor(unit), 6);
      key += (key.empty() ? "" : ", ") + place;
    }
    if (const unsigned int n = ++seen[key]; n > 1)
      key += " (" + std::to_string(n) + ")";
    Table::Row &row = table.rows[key];
    row.status = field["status"];
    for (const Column &column : layout.columns)
      row.numbers[column.name] =
          number_in(field[column.name], column.name, path) * factor(column.unit);
  }
  return table;
}

struct Difference {
  std::string what;
  double first, second;
  double size() const { return std::abs(second - first); }
};

/// Say by how much a column differs at most, beside the largest number of its kind. @return whether
/// it does
bool print_worst(const std::string &column, const double scale, std::vector<Difference> &list) {
  std::stable_sort(list.begin(), list.end(),
                   [](const Difference &x, const Difference &y) { return x.size() > y.size(); });
  if (list.empty() || list.front().size() <= equal_numbers * scale)
    return false;
  const Difference &worst = list.front();
  std::cout << "  " << column << ": by " << rounded_number(worst.second - worst.first, 4) << " at "
            << worst.what << " (" << rounded_number(worst.first, 5) << " -> "
            << rounded_number(worst.second, 5) << "), "
            << rounded_number(100. * worst.size() / scale, 3) << " % of the largest\n";
  return true;
}

/// The largest differences of each column, and changes of status.
void compare(const Run &first, const Run &second, const Layout &layout) {
  constexpr std::size_t most = 5;
  const Table a = read_table(first, first, layout), b = read_table(second, first, layout);
  if (a.rows.empty() && b.rows.empty())
    return;
  std::size_t alone = 0, changed = 0, gone = 0;
  std::string states;
  std::map<std::string, std::vector<Difference>> found;
  std::map<std::string, double> largest; // by unit
  for (const auto &[key, row] : a.rows) {
    const auto other = b.rows.find(key);
    if (other == b.rows.end()) {
      ++alone;
      continue;
    }
    if (row.status != other->second.status && ++changed <= most)
      states += "    " + key + ": " + row.status + " -> " + other->second.status + "\n";
    for (const auto &[column, unit] : layout.columns) {
      const double x = row.numbers.at(column), y = other->second.numbers.at(column);
      if (std::isnan(x) != std::isnan(y))
        ++gone;
      else if (!std::isnan(x)) {
        found[column].push_back({key, x, y});
        largest[unit] = std::max({largest[unit], std::abs(x), std::abs(y)});
      }
    }
  }
  for (const auto &row : b.rows)
    alone += a.rows.count(row.first) == 0 ? 1 : 0;
  std::cout << layout.title << ":\n";
  if (alone > 0)
    std::cout << "  " << alone << " rows are in one of the two runs only\n";
  if (gone > 0)
    std::cout << "  " << gone << " numbers are in one of the two runs only\n";
  if (changed > 0)
    std::cout << "  " << changed << " states changed\n" << states;
  bool any = false;
  for (const auto &[column, unit] : layout.columns)
    any = print_worst(column, largest[unit], found[column]) || any;
  if (!any && changed == 0 && alone == 0 && gone == 0)
    std::cout << "  the same\n";
}

/// Checks that only one of the runs makes, and what fails in one only. Of what passes a run names
/// the nearest to failing alone.
void compare_checks(const Run &first, const Run &second) {
  std::string text;
  const auto say = [&](const Run &run, const Run &other, const std::string &which) {
    for (const auto &[check, failing] : run.failures) {
      const auto found = other.failures.find(check);
      if (found == other.failures.end())
        text += "  " + check + " is checked in the " + which + " run only\n";
      for (const std::string &of : failing)
        if (found == other.failures.end() || found->second.count(of) == 0)
          text += "  " + check + " of " + of + " fails in the " + which + " run only\n";
    }
  };
  say(first, second, "first");
  say(second, first, "second");
  if (!first.failures.empty() || !second.failures.empty())
    std::cout << "Checks:\n" << (text.empty() ? "  the same\n" : text);
}

/// The texts of a run's other tables than these, by name.
std::map<std::string, std::string> tables_in(const std::string &folder,
                                             const std::set<std::string> &without) {
  std::map<std::string, std::string> texts;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string();
        entry.path().extension() == ".csv" && without.count(name) == 0) {
      std::ifstream in(entry.path());
      texts[name] = {std::istreambuf_iterator<char>(in), {}};
    }
  return texts;
}

/// Tables whose numbers are not compared: which are written otherwise.
void compare_others(const Run &first, const Run &second, const std::vector<Layout> &compared) {
  std::set<std::string> without = {"convergence.csv"}; // with the seconds that each mesh took
  for (const Layout &layout : compared)
    without.insert(layout.file);
  const auto a = tables_in(first.folder, without), b = tables_in(second.folder, without);
  std::set<std::string> names;
  std::vector<std::string> differ;
  for (const auto *const tables : {&a, &b})
    for (const auto &table : *tables)
      names.insert(table.first);
  for (const std::string &name : names)
    if (a.count(name) == 0 || b.count(name) == 0 || a.at(name) != b.at(name))
      differ.push_back(name);
  if (!names.empty())
    std::cout << "Other tables, as they are written:\n"
              << (differ.empty() ? "  the same" : "  " + join(differ) + " differ") << '\n';
}

/// What to know of the numbers of a run that has not converged.
void warn(const Run &run) {
  if (run.status != "converged")
    std::cout
        << "The run in " << run.folder << " has ended with '" << run.status
        << "': its numbers are those of the last state that was found, not of the whole case\n";
}

/// The second of two quantities of one name in the unit of the first.
/// @throws UserError if that is not known
double in_unit_of(const QuantityOfRun &first, const QuantityOfRun &second,
                  const std::string &name) {
  if (first.unit == second.unit)
    return second.value;
  if (first.in_si == 0. || second.in_si == 0.)
    throw UserError("The two runs have quantity " + name +
                    " in units that cannot be converted.\n  read:    " + first.unit + " and " +
                    second.unit +
                    "\n  allowed: one unit, or two that follow from Units\n  try:     "
                    "the same 'unit' in both files, or none");
  return second.value * (second.in_si / first.in_si);
}

} // namespace

int compare_runs(const std::string &first, const std::string &second) {
  const Run a = read_run(first), b = read_run(second);
  std::cout << "What changes from " << first << " to " << second << '\n';
  warn(a);
  warn(b);
  std::cout << "Quantities:\n";
  std::size_t n_same = 0;
  for (const auto &[name, quantity] : a.quantities) {
    const auto other = b.quantities.find(name);
    if (other == b.quantities.end()) {
      std::cout << "  " << name << " is in the first run only\n";
      continue;
    }
    const double x = quantity.value, y = in_unit_of(quantity, other->second, name);
    if (std::abs(y - x) <= equal_numbers * std::max(std::abs(x), std::abs(y)))
      ++n_same;
    else
      std::cout << "  " << name << ": " << rounded_number(x, 6) << " -> " << rounded_number(y, 6)
                << (quantity.unit == "-" ? "" : " " + quantity.unit)
                << (x != 0. ? " (" + rounded_number(100. * (y - x) / std::abs(x), 3) + " %)" : "")
                << '\n';
  }
  for (const auto &quantity : b.quantities)
    if (a.quantities.count(quantity.first) == 0)
      std::cout << "  " << quantity.first << " is in the second run only\n";
  if (n_same > 0)
    std::cout << "  " << n_same << " are the same\n";
  compare_checks(a, b);
  // Not by their increments, of which the runs may have different numbers.
  const std::vector<Layout> layouts = {
      {"Supports",
       "supports.csv",
       {{"support", ""}, {"step", ""}, {"time", "s"}},
       {{"fn", "N"},
        {"ft1", "N"},
        {"ft2", "N"},
        {"gap", "m"},
        {"slip1", "m"},
        {"slip2", "m"},
        {"mt", "N m"}}},
      {"Reactions",
       "reactions.csv",
       {{"restraint", ""}, {"step", ""}, {"time", "s"}},
       {{"fx", "N"}, {"fy", "N"}, {"fz", "N"}, {"mx", "N m"}, {"my", "N m"}, {"mz", "N m"}}},
      {"Line",
       "line.csv",
       {{"step", ""}, {"pipe", ""}, {"s", "m"}},
       {{"ux", "m"},
        {"uy", "m"},
        {"uz", "m"},
        {"N", "N"},
        {"Vy", "N"},
        {"Vz", "N"},
        {"Mx", "N m"},
        {"My", "N m"},
        {"Mz", "N m"}}},
      {"Contact",
       "contact.csv",
       {{"surface", ""}, {"step", ""}, {"x", "m"}, {"y", "m"}, {"z", "m"}},
       {{"pressure", "Pa"},
        {"t1", "Pa"},
        {"t2", "Pa"},
        {"gap", "m"},
        {"slip1", "m"},
        {"slip2", "m"},
        {"ux", "m"},
        {"uy", "m"},
        {"uz", "m"}}},
      {"Stresses",
       "stresses.csv",
       {{"case", ""}, {"kind", ""}, {"pipe", ""}, {"s", "m"}},
       {{"stress", "Pa"}, {"utilization", "-"}}},
      {"Modes", "modes.csv", {{"mode", ""}}, {{"frequency", "Hz"}}}};
  for (const Layout &layout : layouts)
    compare(a, b, layout);
  compare_others(a, b, layouts);
  return 0;
}

} // namespace frictionbeam
