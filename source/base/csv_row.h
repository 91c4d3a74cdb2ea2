// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/// Fields of a row of a csv file that this program wrote; one in quotes may have commas. What users
/// write is read by scene/file/table_rows.h.
inline std::vector<std::string> csv_fields(const std::string &row) {
  std::vector<std::string> result(1);
  bool quoted = false;
  for (const char c : row)
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      result.emplace_back();
    else
      result.back() += c;
  return result;
}

} // namespace frictionbeam
