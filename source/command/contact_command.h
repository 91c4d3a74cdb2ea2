// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <string>

namespace frictionbeam {

struct ContactOptions {
  std::string file;
  double tolerance = 1e-8;                                     ///< of both residuals
  double time_limit = std::numeric_limits<double>::infinity(); ///< [s]
};

/**
 * `frictionbeam contact FILE`: solve the friction-contact problem of an FCLIB file, local or
 * global, write the solution into it and print its residual.
 * @return the exit status: 0 solved, 2 not converged.
 */
int solve_contact_file(const ContactOptions &options);

} // namespace frictionbeam
