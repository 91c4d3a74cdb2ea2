// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

namespace frictionbeam {

/// The exit status of a command, and of what it throws, which is printed: 1 of the user's input, 4
/// where results cannot be written, 128 and the signal that interrupts, 3 of our own mistakes.
int with_errors_told(const std::function<int()> &command);

/// All that `frictionbeam` does with its command line; errors are printed. @return exit status
int run_program(int argc, char **argv);

} // namespace frictionbeam
