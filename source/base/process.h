// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/// How a process ended.
struct ProcessResult {
  int exit_status = -1; ///< -1: ended by a signal, or not begun
  bool timed_out = false;
  double seconds = 0.;           ///< wall time from start to end
  double processor_seconds = 0.; ///< of the process and of those it waited for, system time too
  double peak_memory_mb = 0.;    ///< of the process and of those it waited for
  std::string output;            ///< standard output and errors
};

/// Run a program and wait for it, for @p time_limit seconds at most. It ends with its parent.
ProcessResult run_process(const std::vector<std::string> &words, const std::string &folder,
                          const double time_limit);

/// Path of this program.
std::string own_path();

} // namespace frictionbeam
