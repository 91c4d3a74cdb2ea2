// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"
#include "results/solid/wall_state.h"

namespace frictionbeam {

/**
 * The state of a wall as a line's frame: stations at the rings, with the section's motion as a plane
 * and the forces across it, axes and signs as of a line; N is the effective force, of the wall less
 * pressure times bore, as a beam has it. Supports are the sums over their patches.
 * @param line the scene as a line, in whose order supports and restraints stand
 */
Frame solid_frame(const Scene &scene, const Model &line, const PipeWall &wall,
                  const WallLoads &loads, const ContinuumBody<3> &body,
                  const FoundationContacts &contacts, const ContinuumState &state,
                  const std::vector<RingState> &rings);

} // namespace frictionbeam
