// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * Write `report.html`, one page that needs nothing else and no network, `line.svg`, the line at
 * the end of the last step, and where pipes yield or creep `sections.svg`, into @p folder. The page
 * shows status, quantities, the line step by step, section forces, histories, supports, reactions,
 * what the solver did, and the input. A large model is thinned out for it, and the page says what
 * is left out and which csv file has it.
 *
 * Works for a run that failed as well, with what there is. Throws UserError if a file cannot be
 * written; charts that gnuplot cannot draw are replaced by a line that says so.
 */
void write_report(const Scene &scene, const Results &results, const std::string &folder);

} // namespace frictionbeam
