// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include "scene/scene.h"

namespace frictionbeam {

/**
 * What a rigid pipe's own forces make of it, at least roughly: max(int |N|/EA ds, L/3 int |M|/EI
 * ds), with the thousandfold rigidities of its section, over the largest displacement of the frame.
 * It is that of a beam on two ends under a force in its middle within a factor of 2.
 */
struct SoftRigidPipe {
  unsigned int pipe = 0;
  double share = 0.; ///< of the largest displacement; 0: there is no rigid pipe
};
/// The one that deforms most.
SoftRigidPipe softest_rigid_pipe(const Scene &scene, const Frame &frame);

} // namespace frictionbeam
