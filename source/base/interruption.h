// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>

/**
 * @file
 * SIGINT and SIGTERM ask the program to end. A signal's handler can do no more than raise a flag,
 * so this is the one place with a state of the process. A sequence looks at the flag between its
 * increments, where it can be written and resumed; the loops within an increment end the run only
 * if that takes too long.
 */
namespace frictionbeam {

/// The run ends since a signal asked for it; main() ends with exit status 128 + signal.
class Interrupted : public std::runtime_error {
public:
  Interrupted(const int signal, const std::string &message)
      : std::runtime_error(message), signal(signal) {}
  const int signal;
};

namespace interruption {

/// From now on SIGINT and SIGTERM raise the flag, and the second one ends the process at once.
void listen();

/// The signal that was received; 0: none.
int received();

/// To be called in loops that may last, where no checkpoint can be written.
/// @throws Interrupted if a signal came some seconds ago.
void end_if_overdue();

} // namespace interruption

} // namespace frictionbeam
