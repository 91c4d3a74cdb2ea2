// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/page/html.h"
#include "results/text.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr std::size_t n_panels_at_most = 64;
constexpr std::size_t n_unwrapped = 36; ///< characters of a cell that stay in one line

const char *const style = R"(
:root { color-scheme: light }
* { box-sizing: border-box }
body { margin: 0 auto; padding: 0 28px 60px; max-width: 1240px; background: #fff; color: #1b1f24;
  font: 15px/1.45 system-ui, "Segoe UI", "Noto Sans", "Liberation Sans", Arial, sans-serif }
h1 { font-size: 27px; line-height: 1.2; margin: 28px 0 4px }
h2 { font-size: 19px; margin: 38px 0 10px; padding-top: 10px; border-top: 1px solid #d5dae0 }
h3 { font-size: 15px; margin: 22px 0 6px }
p { margin: 6px 0; max-width: 95ch }
.facts { color: #57606a; max-width: none }
.facts span + span::before { content: "\00b7"; margin: 0 8px }
.status { margin: 16px 0; padding: 12px 18px; border-left: 8px solid; border-radius: 4px }
.status b { font-size: 20px; margin-right: 14px; letter-spacing: .02em }
.converged { background: #e4f4ee; border-color: #009e73 }
.no_equilibrium { background: #fdf1dc; border-color: #e69f00 }
.failed { background: #fbe6da; border-color: #d55e00 }
.checks_fail { background: #fdf1dc; border-color: #d55e00 }
.verdicts { margin: 12px 0 }
.verdicts a { color: #0b5cad }
tr.fails td, tr.fails:nth-child(even) td { background: #fbe6da; font-weight: 600 }
.remarks { margin: 12px 0; padding: 10px 18px; background: #fdf8ea; border: 1px solid #ecdcae;
  border-radius: 4px }
.remarks ul { margin: 4px 0; padding-left: 20px }
nav { position: sticky; top: 0; z-index: 3; margin: 10px -6px 0; padding: 7px 0; background: #fff;
  border-bottom: 1px solid #d5dae0; font-size: 13.5px }
nav a { color: #0b5cad; text-decoration: none; margin: 0 8px; white-space: nowrap }
nav a:hover { text-decoration: underline }
section { scroll-margin-top: 34px }
.scroll { overflow: auto; max-height: 470px; width: fit-content; max-width: 100%;
  border: 1px solid #d5dae0; border-radius: 4px }
table { border-collapse: separate; border-spacing: 0; font-size: 13.5px;
  font-variant-numeric: tabular-nums }
th, td { padding: 4px 10px; white-space: nowrap; text-align: left; vertical-align: top }
th { position: sticky; top: 0; background: #eef1f5; font-weight: 600; white-space: nowrap;
  cursor: pointer; border-bottom: 1px solid #d5dae0 }
th small { color: #57606a; font-weight: 400 }
tr:nth-child(even) td { background: #f8f9fb }
.r { text-align: right }
.wrap { white-space: normal; min-width: 26ch; max-width: 60ch }
td svg { width: 13px; height: 13px; vertical-align: -2px; margin-right: 6px }
.note { color: #57606a; font-size: 13px }
.key { font-size: 13px; margin: 0 0 4px }
.key span { margin-right: 26px; white-space: nowrap }
.key span::before { content: ""; display: inline-block; width: 26px; height: 3px; margin-right: 8px;
  vertical-align: 4px; background: var(--c) }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(500px, 1fr)); gap: 14px }
.charts svg, .picture svg { width: 100%; height: auto; display: block }
.picture { border: 1px solid #d5dae0; border-radius: 4px; overflow: hidden }
.tabs > input { position: absolute; opacity: 0; pointer-events: none }
.tabs > label { display: inline-block; padding: 5px 14px; margin: 0 3px 6px 0; cursor: pointer;
  border: 1px solid #d5dae0; border-radius: 4px; font-size: 13.5px }
.tabs > label:hover { background: #eef1f5 }
.tabs > .panel { display: none }
.columns { display: flex; flex-wrap: wrap; gap: 10px 40px }
pre { margin: 0; padding: 12px 16px; max-height: 520px; overflow: auto; background: #f6f8fa;
  border: 1px solid #d5dae0; border-radius: 4px;
  font: 12.5px/1.45 ui-monospace, "DejaVu Sans Mono", "Liberation Mono", monospace }
@media print { nav, .tabs > label { display: none } .tabs > .panel { display: block !important }
  .scroll, pre { max-height: none } body { max-width: none; padding: 0 } }
)";

/// A click on a table's head sorts by that column; another one turns the order round.
const char *const script = R"(
for (const head of document.querySelectorAll('th')) head.onclick = () => {
  const table = head.closest('table'), place = head.cellIndex;
  const turned = table.dataset.by == place ? -1 : 1;
  table.dataset.by = turned < 0 ? '' : place;
  const key = row => row.cells[place].textContent.trim();
  const compare = (a, b) => {
    const x = parseFloat(key(a)), y = parseFloat(key(b));
    return isNaN(x) || isNaN(y) ? key(a).localeCompare(key(b), 'en', {numeric: true}) : x - y;
  };
  [...table.tBodies[0].rows].sort((a, b) => turned * compare(a, b))
    .forEach(row => table.tBodies[0].append(row));
};
)";

std::string tab_rules() {
  std::string rules;
  for (std::size_t i = 1; i <= n_panels_at_most; ++i) {
    const std::string place = ":nth-of-type(" + std::to_string(i) + ")";
    const std::string checked = ".tabs > input" + place + ":checked ~ ";
    rules += checked + "label" + place + " { background: #1b4f8f; color: #fff }\n" + checked +
             ".panel" + place + " { display: block }\n";
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
  columns.push_back({"<th class=\"r\">" + escape_xml(header), "<td class=\"r\">", escaped(cells)});
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
  if (titles_and_panels.size() == 1)
    return titles_and_panels.front().second;
  std::string inputs, labels, panels;
  for (std::size_t i = 0; i < titles_and_panels.size(); ++i) {
    const std::string tab = id + "-" + std::to_string(i);
    inputs += "<input type=\"radio\" name=\"" + id + "\" id=\"" + tab + "\"" +
              (i + 1 == titles_and_panels.size() ? " checked" : "") + ">";
    labels += "<label for=\"" + tab + "\">" + escape_xml(titles_and_panels[i].first) + "</label>";
    panels += "<div class=\"panel\">" + titles_and_panels[i].second + "</div>\n";
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
         escape_xml(title) + "</title>\n<style>" + style + tab_rules() +
         "</style>\n</head>\n<body>\n" + body + "<script>" + script +
         "</script>\n</body>\n</html>\n";
}

} // namespace frictionbeam
