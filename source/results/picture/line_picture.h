// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * The line in isometric view (z up, x to the lower right, y to the upper right) as one SVG element
 * that also stands as a file of its own: as built in grey, displaced with the factor @p scale in
 * the colours of the displacement, supports as markers of their status, restraints as triangles,
 * with a legend. Stations and markers that cannot be told apart are left out.
 */
std::string draw_line(const Scene &scene, const Results &results, const Frame &frame,
                      const double scale);

} // namespace frictionbeam
