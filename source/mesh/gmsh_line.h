// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/mesh/line_mesh.h>

/// @file The two ways from gmsh to a LineMesh with vertices, pipes and named points; private to the
/// mesh stage.
namespace frictionbeam {

/// Keeps gmsh initialized, silent, and without the user's configuration.
class GmshSession {
public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession &) = delete;
  GmshSession &operator=(const GmshSession &) = delete;
};

/// Mesh the routes of the scene's pipes.
LineMesh mesh_routes(const Scene &scene);

/// Read or mesh Mesh/File, whose physical curves are the scene's pipes.
LineMesh mesh_file(const Scene &scene);

} // namespace frictionbeam
