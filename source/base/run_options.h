// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/// Which case to run, and how.
struct RunOptions {
  std::string parameter_file;
  std::vector<std::string> overrides; ///< of --set
  std::string output_directory;       ///< empty: output/<name of the parameter file>
  bool resume = false;                ///< from the checkpoint of a run that was killed
  bool quiet = false;                 ///< print errors only
  bool strict = false;                ///< what is hardly meant is an error
};

} // namespace frictionbeam
