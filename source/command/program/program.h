// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam {

/// All that `frictionbeam` does with its command line; errors are printed. @return exit status
int run_program(int argc, char **argv);

} // namespace frictionbeam
