// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/known_error.h"
#include "results/solid/solid_files.h"

namespace frictionbeam {

/// Where the equivalent stress of a wall, which is taken for elastic, is the most times the Yield
/// stress of its material, in words; empty: nowhere above it.
/// @param frames whose steps are those of the scene
std::string doubt_of_stresses(const Scene &scene, const PipeWall &wall,
                              const std::vector<WallFrame> &frames);

/// Where the radial stress of the bore misses the pressure there by the most, if by more than a
/// twentieth of the largest equivalent stress beside it, in words: the wall's stresses are known no
/// better. But for the rings at and next to its ends.
std::string doubt_of_bore(const Scene &scene, const PipeWall &wall,
                          const std::vector<WallFrame> &frames);

/// What the cells of section Solid leave of the displacements of a wall with bends: of their
/// flexibility (flexibility_error()).
/// @param scene of the wall's pipes, which have one section @param name of the wall, in words
KnownError error_of_cells(const Scene &scene, const std::string &name);

/// How well a solid pipe is known by its bends; its load increments where nothing can slip.
HowWellKnown how_well_known_of_wall(const Scene &scene);

} // namespace frictionbeam
