// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"

namespace frictionbeam {

/// Read or mesh Mesh/File, whose physical curves are the scene's pipes: a LineMesh with vertices,
/// pipes and named points.
LineMesh mesh_file(const Scene &scene);

} // namespace frictionbeam
