// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/// Between which the pressure in a pipe is [Pa]: the sum of the loads with their factors and
/// histories, at the end of a static step and over a transient one; of a combination, as it
/// combines its cases.
struct PressureBounds {
  double least = 0., largest = 0.;
};
PressureBounds pressure_bounds(const Scene &scene, const std::string &step,
                               const unsigned int pipe);

/// Of these, that of the largest size [Pa].
double pressure_in(const Scene &scene, const std::string &step, const unsigned int pipe);

} // namespace frictionbeam
