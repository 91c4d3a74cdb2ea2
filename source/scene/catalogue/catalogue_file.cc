// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/catalogue/catalogue_file.h"

#include "scene/file/parameter_file.h"
#include "scene/file/table_rows.h"
#include "scene/units.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace frictionbeam {

namespace {

/// How many of @p si_unit one of @p unit is, by the words of entry Units ("N/mm" is N over mm);
/// empty for another unit.
std::optional<double> factor_of_unit(const std::string &unit, const std::string &si_unit) {
  const auto slash = unit.find('/');
  const std::string first = unit.substr(0, slash),
                    second = slash == std::string::npos ? "" : unit.substr(slash + 1);
  const auto system = UnitSystem::parse(si_unit == "N"    ? "m " + unit
                                        : si_unit == "m"  ? unit + " N"
                                        : si_unit == "kg" ? "m N " + unit
                                                          : second + " " + first);
  if (!system || system->name(si_unit) != unit)
    return {};
  return system->factor(si_unit);
}

/// One table, line by line.
class CatalogueReader {
public:
  CatalogueReader(const std::string &file, const std::vector<CatalogueColumn> &columns)
      : file(file), columns(columns), place_of(columns.size(), nowhere),
        factor_of(columns.size(), 1.) {}

  std::vector<CatalogueRow> read() {
    for (const TableRow &row : read_table_rows(file)) {
      line = row.line;
      if (n_fields == 0) {
        separator = separator_of(row.text);
        read_header(fields_of_row(row.text, separator));
      } else
        read_row(fields_of_row(row.text, separator));
    }
    if (rows.empty())
      fail(n_fields == 0 ? "an empty file" : "a header without rows", "at least one item",
           "a header '" + header() + "' and a row below it");
    return rows;
  }

private:
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  [[noreturn]] void fail(const std::string &read, const std::string &allowed,
                         const std::string &hint) const {
    throw std::runtime_error(file + ":" + std::to_string(line) + ": read " + read +
                             "; allowed: " + allowed + "; try: " + hint);
  }

  std::string header() const {
    std::string text = "item";
    for (const CatalogueColumn &column : columns)
      text += ", " + column.name + " [" + column.si_unit + "]";
    return text;
  }

  /// The factor of a unit in brackets.
  double factor(const std::string &unit, const CatalogueColumn &column) const {
    if (const auto known = factor_of_unit(unit, column.si_unit))
      return *known;
    fail("the unit '" + unit + "' of column '" + column.name + "'",
         "a unit like " + column.si_unit + " by these words: " + UnitSystem::known_words(),
         "'" + column.name + " [" + column.si_unit + "]'");
  }

  void read_header(const std::vector<std::string> &fields) {
    n_fields = fields.size();
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto bracket = fields[i].find('['), end = fields[i].find(']');
      const std::string name = tidy(fields[i].substr(0, bracket));
      const auto found =
          std::find_if(columns.begin(), columns.end(),
                       [&](const CatalogueColumn &column) { return column.name == name; });
      if (found == columns.end()) {
        if (name == "item" && place_of_item == nowhere)
          place_of_item = i;
        else if (name != "note")
          fail("the column '" + fields[i] + "'", header() + ", note, each once",
               "one of these, or removing it");
        continue;
      }
      const std::size_t c = found - columns.begin();
      if (place_of[c] != nowhere)
        fail("the column '" + name + "' twice", header() + ", note, each once", "removing one");
      if (bracket == std::string::npos || end == std::string::npos || end < bracket)
        fail("the column '" + fields[i] + "' without a unit", "a unit in brackets",
             "'" + name + " [" + found->si_unit + "]'");
      place_of[c] = i;
      factor_of[c] = factor(tidy(fields[i].substr(bracket + 1, end - bracket - 1)), *found);
    }
    if (place_of_item == nowhere)
      fail("no column 'item'", "a header '" + header() + "'",
           "that column, with a name in each row");
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (place_of[c] == nowhere)
        fail("no column '" + columns[c].name + "'", "a header '" + header() + "'", "that column");
  }

  void read_row(const std::vector<std::string> &fields) {
    if (fields.size() != n_fields)
      fail(std::to_string(fields.size()) + " fields",
           std::to_string(n_fields) + ", as in the header", "quotes around a text with a comma");
    CatalogueRow row;
    row.item = fields[place_of_item];
    row.line = line;
    if (row.item.empty())
      fail("an item without a name", "a name in each row", "one");
    for (const CatalogueRow &other : rows)
      if (other.item == row.item)
        fail("the item '" + row.item + "' again, which line " + std::to_string(other.line) + " has",
             "items of different names", "another name");
    for (std::size_t c = 0; c < columns.size(); ++c) {
      double value;
      if (!to_number(fields[place_of[c]], value) || !(value > 0.) || !std::isfinite(value))
        fail("'" + fields[place_of[c]] + "' for '" + columns[c].name + "' of item '" + row.item +
                 "'",
             "a number > 0", "its value in the unit of the header");
      row.numbers.push_back(factor_of[c] * value);
    }
    rows.push_back(row);
  }

  const std::string file;
  const std::vector<CatalogueColumn> &columns;
  unsigned int line = 0;
  char separator = ','; ///< of the header
  std::size_t n_fields = 0, place_of_item = nowhere;
  std::vector<std::size_t> place_of;
  std::vector<double> factor_of;
  std::vector<CatalogueRow> rows;
};

} // namespace

std::vector<CatalogueRow> read_catalogue(const std::string &file,
                                         const std::vector<CatalogueColumn> &columns) {
  return CatalogueReader(file, columns).read();
}

} // namespace frictionbeam
