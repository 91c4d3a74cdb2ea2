// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// The parts of the report that gnuplot draws, as HTML.
struct ReportCharts {
  std::string section_forces, histories;
};

/// Draw the section forces of @p frames along the pipes, steps one over the other, and the motions
/// of the monitored points, by one gnuplot process. Where it is missing, the HTML says so.
ReportCharts make_report_charts(const Scene &scene, const Results &results,
                                const std::vector<const Frame *> &frames);

} // namespace frictionbeam
