// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "base/run_options.h"

namespace frictionbeam::study {

/**
 * `frictionbeam study CASE`: solve the case many times with other values for the entries that its
 * sections Vary name, and write what becomes of its results.
 * @return exit status: 0 all runs converged, 2 some did not, 3 some ended by a mistake of the
 * program. @throws UserError for what the user can put right
 */
int study_command(const RunOptions &options);

} // namespace frictionbeam::study
