// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/**
 * Have gmsh open Mesh/File and, if it is a geometry, mesh it by cells of up to @p dim dimensions.
 *
 * A .geo file is a program, and gmsh believes what a .msh file says of its lengths: so a child
 * process does it first, and what ends that one (Exit, a crash, no end of time or memory) is the
 * user's to know. How many cells there will be is asked of coarser meshes, which cost little.
 *
 * @throws UserError if there is no such file, if gmsh ends or would not end on it, if there are
 * more cells than Mesh/Most cells, or coordinates that are none.
 */
void open_own_mesh(const Scene &scene, const int dim);

/// @throws UserError for @p n cells, if that is more than Mesh/Most cells.
void refuse_too_many_cells(const Scene &scene, const double n);

} // namespace frictionbeam
