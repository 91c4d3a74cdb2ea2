// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <optional>

namespace frictionbeam {

/// Largest and least principal stress of a pipe's wall, and the largest equivalent ones [Pa].
struct WallStress {
  double most, least, von_mises, tresca;
};

/**
 * Of a straight pipe, each the largest round its outer and inner surface: along N/A + p
 * r_i^2/(r_o^2 - r_i^2) + M r/I (N effective, doc/theory.md), round it and through it those of Lame
 * for a pressure inside, shear M_x r/J and that of a thin ring, 2 V/A at its most. Bends and tees
 * have more of it (their stress intensification), which is left out.
 * @param section with a wall @param force N, Vy, Vz, Mx, My, Mz
 */
WallStress wall_stress(const Section &section, const Motion &force, const double pressure);

/// That of a station of a pipe with a wall that answers elastically; none of others.
std::optional<WallStress> elastic_wall_stress(const Scene &scene, const Station &station);

/// The section of a pipe at a station, of a reducer too.
Section section_at(const Scene &scene, const Station &station);

} // namespace frictionbeam
