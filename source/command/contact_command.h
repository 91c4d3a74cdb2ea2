// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace frictionbeam {

/**
 * `frictionbeam contact FILE`: solve the local friction-contact problem of an FCLIB file, write the
 * solution into it and print its residual.
 * @return the exit status: 0 solved, 2 not converged.
 */
int solve_contact_file(const std::string &path);

} // namespace frictionbeam
