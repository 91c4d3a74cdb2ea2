// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/body/body_sequence.h"
#include "model/body/wall_loads.h"

namespace frictionbeam {

/// What the mesh of a wall leaves, by the direction in which it would have to be finer: squared
/// errors in energy, of the energy, added up over states.
struct WallErrors {
  std::vector<double> along;   ///< of each layer
  double around = 0.;          ///< the circumference
  std::vector<double> middles; ///< of the layers, along the chain [m]

  double all_along() const;
};

/// A wall's mesh on the way to finer ones.
struct WallMesh {
  std::vector<double> halved; ///< middles of layers that are cut in two [m]
  WallErrors left;            ///< by it
};

/**
 * Of jumps of the traction, with p the degree and h a cell's length across the face:
 *   eta^2 = 1/E sum h/(4p) |[sigma n]|^2,
 * over the faces that lie on rings for the layers on either side, over those between cells of a
 * layer for the circumference (doc/solid.md, "Adaptive walls").
 * @param is_pushed of rings that something acts on, where tractions do jump
 */
WallErrors wall_errors(const PipeWall &wall, const WallLoads &loads, const ContinuumBody<3> &body,
                       const std::vector<ContinuumState> &states,
                       const std::vector<bool> &is_pushed);

} // namespace frictionbeam
