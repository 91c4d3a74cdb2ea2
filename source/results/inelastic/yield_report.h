// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// What pipes have yielded and crept, as HTML: the line coloured by it, tables of pipes, hinges and
/// cycles, charts of the sections followed. Empty where no pipe could.
std::string yield_section(const Scene &scene, const Results &results);

/// The line at the end of the run as SVG, coloured by plastic strain, creep strain where that is
/// larger, utilization where there is neither, with rings around hinges.
std::string draw_flow(const Scene &scene, const Results &results);

} // namespace frictionbeam
