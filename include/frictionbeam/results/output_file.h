// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/archive.h>

#include <fstream>
#include <string>

namespace frictionbeam {

/**
 * Create the folder for a run's results, with the folders above it, and prove that files can be
 * written there, before an analysis of an hour finds out. Summary, report and picture of an earlier
 * run are removed, so that a run that dies does not leave those of another one.
 *
 * Throws UserError that names the folder, the system's reason and what to try.
 */
void prepare_output_folder(const std::string &folder);

/// A file being written. Everything that goes wrong is a UserError with the file's path, the
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

/// Write @p text to the file @p path; errors as OutputFile.
void write_file(const std::string &path, const std::string &text);

/// The same, so that at every moment the file is either the old one or the new one, on the disk
/// too.
void replace_file(const std::string &path, const std::string &text);
/// Where replace_file() writes the new one first.
std::string file_beside(const std::string &path);

} // namespace frictionbeam
