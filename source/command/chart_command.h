// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace frictionbeam {

/**
 * `frictionbeam chart LIST`: run the configurations of a list and draw error against time.
 * @param folder where the chart goes; empty: output/chart_<its name>. @return the exit status.
 * @throws UserError for what the user can put right.
 */
int chart_command(const std::string &file, std::string folder);

} // namespace frictionbeam
