// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/page/html.h"
#include "results/page/embedded.h"
#include "results/text.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr std::size_t n_panels_at_most = 64;
constexpr std::size_t n_unwrapped = 36; ///< characters of a cell that stay in one line

std::string tab_rules() {
  std::string rules;
  for (std::size_t i = 1; i <= n_panels_at_most; ++i) {
    const std::string place = ":nth-of-type(" + std::to_string(i) + ")";
    const std::string checked = ".tabs > input" + place + ":checked ~ ";
    rules += checked + "label" + place + " { background: #1b4f8f; color: #fff }\n" + checked +
             ".panel" + place + " { display: block }\n.tabs > input" + place +
             ":focus-visible ~ label" + place + " { outline: 3px solid #e69f00 }\n";
  }
  return rules;
}

std::vector<std::string> escaped(const std::vector<std::string> &texts) {
  std::vector<std::string> result;
  for (const auto &text : texts)
    result.push_back(escape_xml(text));
  return result;
}

} // namespace

std::string optional_number(const std::optional<double> &value, const unsigned int digits) {
  return value && std::isfinite(*value) ? rounded_number(*value, digits) : dash;
}

HtmlTable &HtmlTable::text(const std::string &header, const std::vector<std::string> &cells) {
  const bool wrap = std::any_of(cells.begin(), cells.end(),
                                [](const std::string &cell) { return cell.size() > n_unwrapped; });
  columns.push_back(
      {"<th>" + escape_xml(header), wrap ? "<td class=\"wrap\">" : "<td>", escaped(cells)});
  return *this;
}

HtmlTable &HtmlTable::right(const std::string &header, const std::vector<std::string> &cells) {
  return right_html(header, escaped(cells));
}

HtmlTable &HtmlTable::right_html(const std::string &header, const std::vector<std::string> &cells) {
  columns.push_back({"<th class=\"r\">" + escape_xml(header), "<td class=\"r\">", cells});
  return *this;
}

HtmlTable &HtmlTable::html(const std::string &header, const std::vector<std::string> &cells) {
  columns.push_back({"<th>" + escape_xml(header), "<td>", cells});
  return *this;
}

HtmlTable &HtmlTable::numbers(const std::string &header, const std::string &si_unit,
                              const std::vector<double> &values, const double like) {
  Largest largest;
  largest(like);
  for (const double value : values)
    largest(value);
  const DisplayUnit unit = display_unit(units, si_unit, largest.value());
  const unsigned int decimals = decimals_for(unit.factor * largest.value());
  std::vector<std::string> cells;
  for (const double value : values)
    cells.push_back(std::isfinite(value) ? fixed_number(unit.factor * value, decimals) : "\u2013");
  columns.push_back({"<th class=\"r\">" + escape_xml(header) +
                         (unit.name.empty() ? "" : " <small>" + unit.name + "</small>"),
                     "<td class=\"r\">", cells});
  return *this;
}

std::string HtmlTable::str() const {
  if (columns.empty() || columns.front().cells.empty())
    return html_note("none");
  std::string text = "<div class=\"scroll\"><table><thead><tr>";
  for (const Column &column : columns)
    text += column.header + "</th>";
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t row = 0; row < columns.front().cells.size(); ++row) {
    text += "<tr>";
    for (const Column &column : columns) {
      AssertDimension(column.cells.size(), columns.front().cells.size());
      text += column.open + column.cells[row] + "</td>";
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string html_tabs(const std::string &id,
                      const std::vector<std::pair<std::string, std::string>> &titles_and_panels) {
  AssertIndexRange(titles_and_panels.size(), n_panels_at_most + 1);
  const auto titled = [](const std::pair<std::string, std::string> &panel) {
    return "<h4 class=\"print-only\">" + escape_xml(panel.first) + "</h4>" + panel.second;
  };
  if (titles_and_panels.size() == 1)
    return titled(titles_and_panels.front());
  std::string inputs, labels, panels;
  for (std::size_t i = 0; i < titles_and_panels.size(); ++i) {
    const std::string tab = id + "-" + std::to_string(i);
    inputs += "<input type=\"radio\" name=\"" + id + "\" id=\"" + tab + "\"" +
              (i + 1 == titles_and_panels.size() ? " checked" : "") + ">";
    labels += "<label for=\"" + tab + "\">" + escape_xml(titles_and_panels[i].first) + "</label>";
    panels += "<div class=\"panel\">" + titled(titles_and_panels[i]) + "</div>\n";
  }
  return "<div class=\"tabs\">" + inputs + "\n" + labels + "\n" + panels + "</div>\n";
}

std::string html_section(const std::string &id, const std::string &title, const std::string &body) {
  return "<section id=\"" + id + "\">\n<h2>" + escape_xml(title) + "</h2>\n" + body +
         "</section>\n";
}

std::string html_note(const std::string &text) {
  return "<p class=\"note\">" + escape_xml(text) + "</p>\n";
}

std::string html_page(const std::string &title, const std::string &body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escape_xml(title) + "</title>\n<style>\n" + embedded::page_css + tab_rules() +
         "</style>\n</head>\n<body>\n" + body + "<script>\n" + embedded::page_js +
         "</script>\n</body>\n</html>\n";
}

} // namespace frictionbeam
