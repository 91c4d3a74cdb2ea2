// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * Write `summary.json` into @p folder: case, program, status, quantities with their references and
 * errors, certificate, cost, method, steps, remarks. Numbers in SI units with 17 digits; null where
 * there is none (no reference, nan, infinity). Always valid JSON.
 *
 * Throws UserError if the file cannot be written.
 */
void write_summary(const Scene &scene, const Results &results, const std::string &folder);

/// Version of this program, as in its CMakeLists.txt.
std::string program_version();

/// Version of the deal.II it was compiled with.
std::string deal_ii_version();

} // namespace frictionbeam
