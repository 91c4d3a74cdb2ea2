// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

/// One run of the program's commands in a process of its own that has everything loaded already.
namespace fuzz {

struct Trial {
  std::vector<std::string> words; ///< command line, without the program
  std::string folder;             ///< to run in; results go to its folder `results`
  unsigned int seconds = 2;       ///< of computing until it is asked to end, within 8 s more
  bool keep_before = false, keep_after = false; ///< the folder `results`
  bool interrupted = false; ///< asked to end from the beginning: after one increment
};

struct Outcome {
  /// Empty if all is well; else what is wrong, in words that do not depend on numbers: crash,
  /// hang, exit status, internal error, not finite.
  std::string fault;
  int status = 0;    ///< exit status, or -signal
  bool slow = false; ///< ended on request after the time it may take
  double seconds = 0.;
  std::string output;
};

Outcome run(const Trial &trial);

/// The same in this process, which a crash ends: status and output alone.
Outcome run_here(const Trial &trial);

/// Run in this process, so that those that come after have everything loaded and bound.
void warm_up(const Trial &trial);

/// Text without digits and without what stands in quotes.
std::string without_numbers(const std::string &text);

} // namespace fuzz
