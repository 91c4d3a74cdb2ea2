// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam {

/// How motions become strains.
enum class Kinematics {
  linear,      ///< small displacements and rotations, on the line as it is built
  corotational ///< each beam cell turns with its ends, by any angle; strains are small
};

} // namespace frictionbeam
