// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/page/plot.h"
#include "results/results.h"

namespace frictionbeam {

/**
 * Charts of the sections that were followed, each over all increments that were kept: what does
 * work in them over its strain (moment over curvature, both about the axis of the largest moment
 * and signed; N over eps, Mx over chi), and what has yielded and crept over time.
 */
std::vector<Plot> section_charts(const Results &results);

/// Growth of strain and flow by cycles of loads (Step/Repeat), one chart for each group of cycles.
std::vector<Plot> cycle_charts(const Results &results);

} // namespace frictionbeam
