// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace frictionbeam {

/**
 * `frictionbeam compare FOLDER FOLDER`: what differs between the results of two runs, and where:
 * the quantities, the forces and states of supports, the reactions, and the largest differences
 * along the line or on surfaces in contact, in the units of the first. Rows are matched by their
 * names and times; those that only one run has are counted. What a run is worth that has not
 * converged is said.
 * @return 0; throws UserError if a folder has no results, or a table a text for a number.
 */
int compare_runs(const std::string &first, const std::string &second);

} // namespace frictionbeam
