// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * What an engineer has to look at before the numbers: the solution itself, energy, stresses and
 * nozzles by their codes, rests that lift off, supports beyond their `Capacity`, quantities beyond
 * their `limit` or away from their reference. Of each check all that fails, or else what came
 * nearest to it; what there is nothing to judge of is left out.
 */
std::vector<Verdict> verdicts_of(const Scene &scene, const Results &results);

bool any_fails(const std::vector<Verdict> &verdicts);

/// "2 of 7 checks fail: uplift of rests.3 in hot, ..."; empty if none fails.
std::string failures_in_words(const std::vector<Verdict> &verdicts);

} // namespace frictionbeam
