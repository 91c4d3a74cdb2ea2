// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

/**
 * Longest cell [m] of a pipe on a continuous bed where Mesh/Cell length does not say. A bed carries
 * at nodes: of @p length [m] a hundredth, which leaves half a per cent of the friction to an anchor
 * at its end, but no more than two diameters, some half of the length (4 EI / k)^(1/4) in which a
 * pipe bends in hard ground (k = 1e8 N/m2; a pipe's diameter is sqrt(8 I/A)).
 */
inline double bed_cell_length(const Section &section, const double length) {
  const double diameter = section.outer_radius > 0.
                              ? 2. * section.outer_radius
                              : std::sqrt(8. * section.inertia / section.area);
  return std::min(length / 100., 2. * diameter);
}

} // namespace frictionbeam
