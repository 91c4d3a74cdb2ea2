// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "chart/measurement.h"

namespace frictionbeam::chart {

/// NAME.svg, NAME.csv and NAME.md in @p folder. @throws UserError if they cannot be written.
void write_chart(const ChartList &list, const std::vector<Measurement> &measurements,
                 const std::string &folder);

} // namespace frictionbeam::chart
