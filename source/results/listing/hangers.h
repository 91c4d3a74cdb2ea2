// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <string>

namespace frictionbeam {

/**
 * What the spring hangers carry: at the ends of the static steps that have weight and are not
 * occasional (Stress/Occasional), and before anything has moved. Variability is the largest change
 * of load against that of the hot step, over it, |F - F_hot|/F_hot; where a step's hot load is not
 * above 0 it is infinite. Empty if the hot step was not reached.
 */
std::vector<HangerUse> evaluate_hangers(const Scene &scene, const Results &results);

/// As HTML.
std::string hanger_section(const Results &results);

/// Write hangers.csv, if there are any, in the units of the results.
void write_hangers(const Results &results, const std::string &folder);

} // namespace frictionbeam
