// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace frictionbeam {

/**
 * `frictionbeam compare FOLDER FOLDER`: what differs between the results of two runs, and where:
 * the quantities, the forces and states of supports, the reactions, and the largest differences
 * along the line. Rows are matched by their names; those that only one run has are counted.
 * @return 0; throws UserError if a folder has no results.
 */
int compare_runs(const std::string &first, const std::string &second);

} // namespace frictionbeam
