// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/// What the command line asks for.
struct RunOptions {
  std::string parameter_file;
  std::vector<std::string> overrides; ///< of --set
  std::string output_directory;       ///< empty: output/<name of the parameter file>
  bool resume = false;                ///< from the checkpoint of a run that was killed
};

/// Read a parameter file, solve it and write its results.
/// @return exit status: 0 converged, 2 not. @throws UserError for what the user can put right.
int run_case(const RunOptions &options);

} // namespace frictionbeam
