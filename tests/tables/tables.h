// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "../cases/run_program.h"
#include "../check.h"
#include "base/csv_row.h"

#include <algorithm>
#include <cmath>
#include <iostream>

/// Runs of the program, and the tables that they write.
namespace fs = std::filesystem;

inline std::string program_path, project;

inline void expect(const std::string &what, const bool holds) {
  if (!check::count(holds, "tables", 0))
    std::cerr << what << '\n';
}

/// Rows of a table by the names of its columns.
inline std::vector<std::map<std::string, std::string>> rows_of(const fs::path &file) {
  std::ifstream in(file);
  std::string row;
  std::getline(in, row);
  const std::vector<std::string> header = frictionbeam::csv_fields(row);
  std::vector<std::map<std::string, std::string>> result;
  while (std::getline(in, row)) {
    const std::vector<std::string> fields = frictionbeam::csv_fields(row);
    expect(file.string() + ": as many fields as columns", fields.size() == header.size());
    result.emplace_back();
    for (std::size_t i = 0; i < std::min(fields.size(), header.size()); ++i)
      result.back()[header[i]] = fields[i];
  }
  return result;
}
