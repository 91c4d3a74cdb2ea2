// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "command/run_case.h"

namespace frictionbeam {

/**
 * `frictionbeam check CASE.prm`: read, mesh and number a case, say what was understood, draw the
 * line as it is built into line.svg, and stop before anything is solved.
 * @return 0; what is wrong with the input is thrown as UserError.
 */
int check_case_file(const RunOptions &options);

} // namespace frictionbeam
