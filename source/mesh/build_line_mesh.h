// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"

namespace frictionbeam {

/**
 * Mesh the scene's pipes with gmsh: a vertex at every corner, named point and support, bends cut as
 * finely as Mesh/Cells per bend says, straight runs in one cell or as Mesh/Cell length says. With
 * Mesh/File, the pipes and points are the physical curves and points of that file.
 * @throws UserError for a support off the line, a point that no pipe reaches, a file that cannot be
 * read or whose physical names do not fit.
 */
LineMesh build_line_mesh(const Scene &scene);

} // namespace frictionbeam
