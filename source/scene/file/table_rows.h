// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/// @file
/// Rows of tables in text files, as editors, spreadsheets and measuring programs write them. Every
/// table that a user gives is read through these.

/// A row as it stands in the file.
struct TableRow {
  unsigned int line = 0; ///< of the file, from 1
  std::string text;      ///< without its comment, never blank
};

/**
 * Rows of a file, without comments (from # on, but within quotes) and blank lines; with line ends
 * of Unix, DOS or old Macs, and with or without a byte order mark before the first.
 */
std::vector<TableRow> read_table_rows(const std::string &path);

/// What stands between the fields of @p row: a semicolon, else a tab between two that is not beside
/// a comma, else a comma where it has one outside quotes, else a blank.
char separator_of(const std::string &row);

/**
 * Fields of @p row, tidied. One that begins with a quote ends with one; in between separators are
 * text and two quotes are one. Blanks in a row are one separator.
 */
std::vector<std::string> fields_of_row(const std::string &row, const char separator);

/// Fields of a row of numbers that stands for itself: by its own separator, without empty ones at
/// its end, which spreadsheets add.
std::vector<std::string> fields_of_row(const std::string &row);

} // namespace frictionbeam
