// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/pipe_path.h"

#include <array>

namespace frictionbeam {

/// A stretch of a pipe whose wall is a solid in a mixed model.
struct SolidStretch {
  unsigned int pipe = 0;                        ///< in Scene::pipes
  double from = 0., to = 0.;                    ///< along the pipe [m]
  std::string name;                             ///< of the bends or points that it is about
  std::array<bool, 2> anchored{{false, false}}; ///< whether it ends at an anchor
  bool is_short = false; ///< whether something cuts the straight pipe beside a bend short
};

/**
 * The stretches that Solid/At asks for: bends, or places of straight pipe, and Solid/Reach times
 * r sqrt(r/t) of straight pipe on either side, as far as the pipe and the next bend or anchor leave
 * room.
 * Stretches that meet are one.
 * @throws UserError for points that are on no pipe and pipes whose wall cannot be a solid
 */
std::vector<SolidStretch> solid_stretches(const Scene &scene, const std::vector<PipePath> &paths);

/// Each bend of the scene by itself, from where a bend or anchor or the pipe's beginning is before
/// it to where one is behind it.
std::vector<SolidStretch> rooms_of_bends(const Scene &scene, const std::vector<PipePath> &paths);

} // namespace frictionbeam
