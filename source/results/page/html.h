// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/units.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace frictionbeam {

/// What stands where there is no number.
inline const std::string dash = "\u2013";

/// A number as text, or the dash if there is none or it is not finite.
std::string optional_number(const std::optional<double> &value, const unsigned int digits);

/// An HTML table, given column by column; all columns have equally many rows.
class HtmlTable {
public:
  /// @param units in which numbers are shown
  explicit HtmlTable(const UnitSystem &units = {}) : units(units) {}

  /// Names and words.
  HtmlTable &text(const std::string &header, const std::vector<std::string> &cells);

  /// Numbers in SI units, shown in a multiple of @p si_unit that suits them, all with the same
  /// decimals. One that is not finite becomes a dash. Columns of one kind look alike if each is
  /// told the largest number of all, @p like.
  HtmlTable &numbers(const std::string &header, const std::string &si_unit,
                     const std::vector<double> &values, const double like = 0.);

  /// Numbers that are text already, aligned to the right.
  HtmlTable &right(const std::string &header, const std::vector<std::string> &cells);

  /// The same, as HTML.
  HtmlTable &right_html(const std::string &header, const std::vector<std::string> &cells);

  /// Cells that are HTML already.
  HtmlTable &html(const std::string &header, const std::vector<std::string> &cells);

  /// The table; a long one scrolls in a window of its own.
  std::string str() const;

private:
  struct Column {
    std::string header, open; ///< with the opening tags of the header and of each cell
    std::vector<std::string> cells;
  };
  UnitSystem units;
  std::vector<Column> columns;
};

/// Panels of HTML one behind the other, each with a tab of its title; the last one is in front.
/// Only one panel: no tabs. At most 64 panels.
std::string html_tabs(const std::string &id,
                      const std::vector<std::pair<std::string, std::string>> &titles_and_panels);

/// A section with a heading that can be linked to.
std::string html_section(const std::string &id, const std::string &title, const std::string &body);

/// A remark in small print.
std::string html_note(const std::string &text);

/// The complete page, with its style and the sorting of tables.
std::string html_page(const std::string &title, const std::string &body);

} // namespace frictionbeam
