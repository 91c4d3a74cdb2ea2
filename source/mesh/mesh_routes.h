// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"
#include "mesh/route_plan.h"

namespace frictionbeam {

/// Mesh the routes of the scene's pipes: a LineMesh with vertices, pipes and named points. Runs and
/// bends are divided evenly, without gmsh unless Mesh/Mesher asks for it.
LineMesh mesh_routes(const Scene &scene);

/// The same of a plan, whose pieces are divided evenly.
LineMesh mesh_plan(const Scene &scene, const RoutePlan &plan);

} // namespace frictionbeam
