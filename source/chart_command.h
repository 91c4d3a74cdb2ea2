// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace frictionbeam {

/**
 * `frictionbeam chart LIST [--output-directory FOLDER]`: run the configurations of a list and draw
 * error against time; `frictionbeam chart --print-parameters`: the entries of a list.
 * @param arguments what follows the word chart. @return the exit status.
 * @throws UserError for what the user can put right.
 */
int chart_command(const std::vector<std::string> &arguments);

} // namespace frictionbeam
