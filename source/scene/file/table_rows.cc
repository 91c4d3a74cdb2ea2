// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/file/table_rows.h"

#include "base/file_bytes.h"
#include "scene/file/parameter_file.h"

#include <algorithm>

namespace frictionbeam {

namespace {

bool is_blank(const char c) { return c == ' ' || c == '\t'; }

/**
 * Call @p visit with each character of @p row and whether it is text of a quoted field; its quotes
 * themselves are left out. A quote opens at the beginning of a field only: 6" is an inch.
 * @param is_separator of characters outside quotes
 */
template <typename IsSeparator, typename Visit>
void visit_characters(const std::string &row, const IsSeparator &is_separator, const Visit &visit) {
  bool quoted = false, begins = true;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const char c = row[i];
    if (quoted && c == '"' && i + 1 < row.size() && row[i + 1] == '"')
      visit(c, true, i++);
    else if (quoted && c == '"')
      quoted = false;
    else if (begins && c == '"') {
      quoted = true;
      begins = false;
    } else {
      visit(c, quoted, i);
      begins = !quoted && (is_separator(c) || (begins && is_blank(c)));
    }
  }
}

} // namespace

std::vector<TableRow> read_table_rows(const std::string &path) {
  std::string text = file_bytes(path);
  if (text.rfind("\xef\xbb\xbf", 0) == 0)
    text.erase(0, 3);
  const auto separates = [](const char c) { return c == ',' || c == ';' || is_blank(c); };
  std::vector<TableRow> rows;
  unsigned int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
    ++number;
    std::size_t comment = line.size();
    visit_characters(line, separates, [&](const char c, const bool quoted, const std::size_t i) {
      if (c == '#' && !quoted)
        comment = std::min(comment, i);
    });
    const std::string content = line.substr(0, comment);
    if (content.find_first_not_of(" \t\v\f") != std::string::npos)
      rows.push_back({number, content});
  }
  return rows;
}

char separator_of(const std::string &row) {
  for (const char separator : {';', '\t', ','}) {
    bool found = false, is_tab_open = false; // a tab beside a comma is a blank like any other
    char before = ',';                       // the last that is none
    visit_characters(
        row, [&](const char c) { return c == separator; },
        [&](const char c, const bool quoted, const std::size_t) {
          const bool blank = is_blank(c) && !quoted;
          found = found || (c == separator && !quoted && !blank) ||
                  (is_tab_open && !blank && (c != ',' || quoted));
          is_tab_open = blank && (is_tab_open || (c == '\t' && separator == '\t' && before != ','));
          before = blank ? before : quoted ? '"' : c;
        });
    if (found)
      return separator;
  }
  return ' ';
}

std::vector<std::string> fields_of_row(const std::string &row, const char separator) {
  const auto separates = [separator](const char c) {
    return c == separator || (separator == ' ' && c == '\t');
  };
  std::vector<std::string> fields(1);
  visit_characters(row, separates, [&](const char c, const bool quoted, const std::size_t) {
    if (quoted || !separates(c))
      fields.back() += c;
    else if (separator != ' ' || !fields.back().empty())
      fields.emplace_back();
  });
  for (std::string &field : fields)
    field = tidy(field);
  if (separator == ' ' && fields.back().empty())
    fields.pop_back();
  return fields;
}

std::vector<std::string> fields_of_row(const std::string &row) {
  std::vector<std::string> fields = fields_of_row(row, separator_of(row));
  while (!fields.empty() && fields.back().empty())
    fields.pop_back();
  return fields;
}

} // namespace frictionbeam
