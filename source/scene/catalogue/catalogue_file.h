// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/// A number of a catalogue that a column has in it.
struct CatalogueColumn {
  std::string name;    ///< as in the header, before its unit
  std::string si_unit; ///< N, N/m, m or kg
};

/// A row of a catalogue: its item and the numbers in SI units, in the order of the columns.
struct CatalogueRow {
  std::string item;
  std::vector<double> numbers;
  unsigned int line = 0; ///< of the file, from 1 on
};

/**
 * A table of the user's own: comma-separated values whose first row, not counting comments after #,
 * is a header `item, NAME [UNIT], ...` with the columns in any order, and `note` for what is not
 * read. Numbers are > 0, items are named once.
 * @throws std::runtime_error saying the line, what was read, what is allowed and what to try
 */
std::vector<CatalogueRow> read_catalogue(const std::string &file,
                                         const std::vector<CatalogueColumn> &columns);

} // namespace frictionbeam
