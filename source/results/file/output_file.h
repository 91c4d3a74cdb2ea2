// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/archive.h"

#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace frictionbeam {

/// Results that cannot be written: the path, the system's reason, what is whole, what to try. The
/// program prints the text and ends with exit status 4.
class OutputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// @param what a file or a folder @param error of errno
[[noreturn]] void throw_unwritable(const std::string &what, const std::string &path,
                                   const int error);

/**
 * Create the folder for a run's results, with the folders above it, and prove that files can be
 * written there, before an analysis of an hour finds out. What it holds stays.
 *
 * Throws UserError that names the folder, the system's reason and what to try; OutputError if the
 * disk is full.
 */
void prepare_output_folder(const std::string &folder);

/// A file being written. Everything that goes wrong is an OutputError with the file's path, the
/// system's reason and what to try.
class OutputFile {
public:
  /// Open @p path for writing; what it held is lost unless @p keep is set: then it is written on.
  explicit OutputFile(const std::string &path, const bool keep = false);

  /// The length of the file, which is handed to the disk; reading, the file is cut to it.
  void transfer(Archive &archive);

  /// Where to write. It uses the classic locale.
  std::ostream &stream() { return file; }

  /// Hand everything written so far to the system, and check that it took it.
  void flush();

private:
  std::string path;
  std::ofstream file;
};

/// Appends a row of a table to a text. Two threads may call it at a time.
using AddRow = std::function<void(const std::size_t row, std::string &text)>;

/**
 * Write the rows of a table that may be long, and hand them to the system: their texts are made in
 * blocks, by two threads where there are several blocks and processors, and written in the order of
 * the rows. So no more than a block for each thread is in memory.
 */
void write_rows(const std::size_t n_rows, const AddRow &add_row, OutputFile &file);

/// Write @p text to the file @p path; errors as OutputFile.
void write_file(const std::string &path, const std::string &text);

/// The same, so that at every moment the file is either the old one or the new one, on the disk
/// too.
void replace_file(const std::string &path, const std::string &text);
/// Of texts one after the other, so that no copy of them all is made.
void replace_file(const std::string &path, const std::vector<std::string_view> &texts);
/// Where replace_file() writes the new one first.
std::string file_beside(const std::string &path);

} // namespace frictionbeam
