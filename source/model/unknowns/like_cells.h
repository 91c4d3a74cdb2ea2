// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"
#include <frictionbeam/line_triangulation.h>

namespace frictionbeam {

/**
 * For each cell of a line the first one that is as long and has the same material id: a straight
 * element's matrices are that one's, turned. Lengths are equal that differ by no more than what
 * rounding leaves of the coordinates of the vertices.
 */
std::vector<unsigned int> first_like_cells(const std::vector<Point3> &points,
                                           const std::vector<LineCell> &cells);

} // namespace frictionbeam
