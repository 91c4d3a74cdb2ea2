// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// The force that holds a line up in one case, at one support.
struct Uplift {
  unsigned int support = 0; ///< place in Results::supports
  std::string case_name;
  double least = 0.;  ///< normal force that is left [N]
  bool lifts = false; ///< the pipe stands off, or is pulled at
};

/**
 * Of rests by whatever name and of rods: what is left of the normal force at the end of each static
 * step with loads, and in each sum of cases that has one state in it, such as operating - quake,
 * where sizes count with the sign that leaves least.
 */
std::vector<Uplift> uplifts_of(const Scene &scene, const Results &results);

/// A row for each such support, a column for each case, red where it lifts; empty if none is
/// judged.
std::string uplift_table(const Scene &scene, const Results &results);

/// Write uplift.csv likewise, a row for each support and case.
void write_uplift(const Scene &scene, const Results &results, const std::string &folder);

} // namespace frictionbeam
