// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "gmsh_session.h"

#include <frictionbeam/mesh/line_mesh.h>

/// @file The two ways from gmsh to a LineMesh with vertices, pipes and named points; private to the
/// mesh stage.
namespace frictionbeam {

/// Mesh the routes of the scene's pipes.
LineMesh mesh_routes(const Scene &scene);

/// Read or mesh Mesh/File, whose physical curves are the scene's pipes.
LineMesh mesh_file(const Scene &scene);

} // namespace frictionbeam
