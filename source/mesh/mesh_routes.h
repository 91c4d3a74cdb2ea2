// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"
#include "mesh/route_plan.h"

namespace frictionbeam {

/// Mesh the routes of the scene's pipes: a LineMesh with vertices, pipes and named points. Runs and
/// bends are divided evenly, without gmsh unless Mesh/Mesher asks for it.
LineMesh mesh_routes(const Scene &scene);

/// The vertices inside a piece, which divide its arc length evenly.
std::vector<Point3> points_inside(const RoutePiece &piece);

/// Say what lies between the vertices of a piece of a pipe, which has been divided.
void add_cells(const RoutePiece &piece, MeshedPipe &pipe);

} // namespace frictionbeam
