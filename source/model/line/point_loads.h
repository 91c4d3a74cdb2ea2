// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"

namespace frictionbeam {

/// Forces [N] and moments [N m] of a load at factor one that act on points, by vertex of the mesh:
/// those of kind force, and the weight of masses.
std::map<unsigned int, Motion> point_loads(const Scene &scene, const LineMesh &mesh,
                                           const Load &load);

} // namespace frictionbeam
