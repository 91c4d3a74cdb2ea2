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
#include <fstream>
#include <iostream>
#include <map>

namespace frictionbeam {

namespace {

/// A csv file whose rows are found by their texts: names, steps, and numbers that place them.
struct Table {
  std::vector<std::string> columns;                                        ///< of the numbers
  std::map<std::string, std::pair<std::string, std::vector<double>>> rows; ///< key: status, numbers
};

/// @param n_keys fields that say what a row is about; @param status whether a word follows them
Table read_table(const std::string &path, const unsigned int n_keys, const bool status) {
  std::ifstream in(path);
  Table table;
  std::string line;
  if (!in || !std::getline(in, line))
    return table;
  const unsigned int n_texts = n_keys + (status ? 1 : 0);
  const std::vector<std::string> header = csv_fields(line);
  table.columns.assign(header.begin() + std::min<std::size_t>(n_texts, header.size()),
                       header.end());
  std::map<std::string, unsigned int> seen; // a node may stand twice, with either side
  while (std::getline(in, line)) {
    const std::vector<std::string> row = csv_fields(line);
    if (row.size() != header.size())
      continue;
    std::string key;
    for (unsigned int i = 0; i < n_keys; ++i) {
      double number;
      key += (i > 0 ? ", " : "") +
             (i >= 2 && to_number(row[i], number) ? rounded_number(number, 6) : row[i]);
    }
    if (const unsigned int n = ++seen[key]; n > 1)
      key += " (" + std::to_string(n) + ")";
    std::vector<double> numbers;
    for (unsigned int i = n_texts; i < row.size(); ++i) {
      double number = 0.;
      to_number(row[i], number);
      numbers.push_back(number);
    }
    table.rows[key] = {status ? row[n_keys] : "", numbers};
  }
  return table;
}

struct Difference {
  std::string what;
  double first, second;
  double size() const { return std::abs(second - first); }
};

/// Say by how much a column differs at most. @return whether it does
bool print_worst(const std::string &column, std::vector<Difference> &list) {
  std::stable_sort(list.begin(), list.end(),
                   [](const Difference &x, const Difference &y) { return x.size() > y.size(); });
  double scale = 0.;
  for (const Difference &d : list)
    scale = std::max({scale, std::abs(d.first), std::abs(d.second)});
  if (list.empty() || list.front().size() <= equal_numbers * scale)
    return false;
  const Difference &worst = list.front();
  std::cout << "  " << column << ": by " << rounded_number(worst.second - worst.first, 4) << " at "
            << worst.what << " (" << rounded_number(worst.first, 5) << " -> "
            << rounded_number(worst.second, 5) << "), "
            << rounded_number(100. * worst.size() / scale, 3) << " % of the largest\n";
  return true;
}

/// The largest differences of some columns, and changes of status.
void compare(const std::string &title, const Table &a, const Table &b,
             const std::vector<std::string> &columns) {
  constexpr std::size_t most = 5;
  if (a.rows.empty() && b.rows.empty())
    return;
  std::size_t alone = 0, changed = 0;
  std::string states;
  std::map<std::string, std::vector<Difference>> found;
  for (const auto &[key, row] : a.rows) {
    const auto other = b.rows.find(key);
    if (other == b.rows.end()) {
      ++alone;
      continue;
    }
    if (row.first != other->second.first && ++changed <= most)
      states += "    " + key + ": " + row.first + " -> " + other->second.first + "\n";
    for (const std::string &column : columns) {
      const auto place = std::find(a.columns.begin(), a.columns.end(), column);
      const auto place_b = std::find(b.columns.begin(), b.columns.end(), column);
      if (place != a.columns.end() && place_b != b.columns.end())
        found[column].push_back({key, row.second[place - a.columns.begin()],
                                 other->second.second[place_b - b.columns.begin()]});
    }
  }
  for (const auto &row : b.rows)
    alone += a.rows.count(row.first) == 0 ? 1 : 0;
  std::cout << title << ":\n";
  if (alone > 0)
    std::cout << "  " << alone << " rows are in one of the two runs only\n";
  if (changed > 0)
    std::cout << "  " << changed << " states changed\n" << states;
  bool any = false;
  for (const std::string &column : columns)
    any = print_worst(column, found[column]) || any;
  if (!any && changed == 0 && alone == 0)
    std::cout << "  the same\n";
}

struct QuantityOfRun {
  double value = 0., in_si = 0.; ///< in_si: SI units in its unit; 0: not known
  std::string unit;
};

/// Quantities of summary.json by their names.
std::map<std::string, QuantityOfRun> read_quantities(const std::string &path) {
  std::ifstream in(path);
  const nlohmann::json summary = nlohmann::json::parse(in, nullptr, false);
  if (!in || !summary.contains("quantities"))
    throw UserError("There is no '" + path +
                    "' of this program. Name two folders with results of it: frictionbeam compare "
                    "output/a output/b");
  std::map<std::string, QuantityOfRun> quantities;
  for (const nlohmann::json &quantity : summary.at("quantities")) {
    if (!quantity.at("value").is_number())
      continue;
    const auto in_si = quantity.find("in_si");
    quantities[quantity.at("name")] = {
        quantity.at("value").get<double>(),
        in_si != quantity.end() && in_si->is_number() ? in_si->get<double>() : 0.,
        quantity.at("unit").get<std::string>()};
  }
  return quantities;
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
  const auto a = read_quantities(first + "/summary.json"),
             b = read_quantities(second + "/summary.json");
  std::cout << "What changes from " << first << " to " << second << '\n' << "Quantities:\n";
  std::size_t n_same = 0;
  for (const auto &[name, quantity] : a) {
    const auto other = b.find(name);
    if (other == b.end()) {
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
  if (n_same > 0)
    std::cout << "  " << n_same << " are the same\n";
  compare("Supports", read_table(first + "/supports.csv", 4, true),
          read_table(second + "/supports.csv", 4, true),
          {"fn", "ft1", "ft2", "gap", "slip1", "slip2", "mt"});
  compare("Reactions", read_table(first + "/reactions.csv", 4, false),
          read_table(second + "/reactions.csv", 4, false), {"fx", "fy", "fz", "mx", "my", "mz"});
  compare("Line", read_table(first + "/line.csv", 3, false),
          read_table(second + "/line.csv", 3, false),
          {"ux", "uy", "uz", "N", "Vy", "Vz", "Mx", "My", "Mz"});
  compare("Stresses", read_table(first + "/stresses.csv", 4, false),
          read_table(second + "/stresses.csv", 4, false), {"stress", "utilization"});
  return 0;
}

} // namespace frictionbeam
