// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <ostream>

namespace frictionbeam {

/// Remarks, steps, how well the answer is known, checks that fail and quantities, as a run ends
/// with them.
void print_summary(std::ostream &out, const Scene &scene, const Results &results);

} // namespace frictionbeam
