// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/run_options.h"

namespace frictionbeam {

/// Read a parameter file, solve it and write its results.
/// @return exit status: 0 converged, 2 not. @throws UserError for what the user can put right.
int run_case(const RunOptions &options);

} // namespace frictionbeam
