// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <map>

namespace frictionbeam {

/// Forces of supports and anchors of the same scene as beams and as a solid wall side by side, and
/// charts along the pipes at the end of each step, as HTML.
std::string line_and_solid(const Scene &scene, const Results &line, const Results &solid);

/// Forces and moments that are rounding beside those of the steps, by the unit of the file.
std::map<std::string, double> rounding_of_forces(const Scene &scene, const Results &line,
                                                 const Results &solid);

/// `models.csv`: what, step, component, line, solid; a row for each force of a support or anchor.
void write_line_and_solid(const Scene &scene, const Results &line, const Results &solid,
                          const std::string &folder);

} // namespace frictionbeam
