// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <ostream>
#include <string>

namespace frictionbeam {

/// Remarks, steps, how well the answer is known, checks that fail and quantities, as a run ends
/// with them.
void print_summary(std::ostream &out, const Scene &scene, const Results &results);

/// The step at which the run stopped and why, " It stopped in step 'a': ...", a sentence behind
/// others; empty if none did.
std::string where_it_stopped(const Results &results);

/// Why a run has no answer, and of when the last state is that its files in @p folder have.
std::string why_unsolved(const Results &results, const std::string &folder);

} // namespace frictionbeam
