// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/body/body_sequence.h"
#include "model/body/pressure_stiffness.h"
#include "model/body/wall_loads.h"
#include "results/results.h"

#include <array>
#include <vector>

namespace frictionbeam {

/// Stress at a point of the wall's surface in the directions axis, circumference, radius [Pa].
struct WallStress {
  double axial = 0., hoop = 0., radial = 0.;
  double shear = 0., axial_radial = 0., hoop_radial = 0.; ///< shear: axis with circumference

  double mises() const;
};

/// A cross-section of the wall.
struct RingState {
  Motion displacement{}; ///< mean over the section: its motion as a plane [m, rad]
  /// Force and moment about the middle on the section of the wall [N, N m], global axes: of what is
  /// behind it on what is before; at the ring as the layer before, or behind, has them.
  std::array<Motion, 2> cut{};
  /// Force and moment of what holds the section there, contacts left out [N, N m].
  Motion held{};
  /// By how much the fluid's thrust on the section, and its moment about the middle, differ by the
  /// motion of the bore there, of a wall that pressure stiffens [N, N m].
  Motion moved_thrust{};
  double widening = 0.; ///< mean of the radial displacement [m]
  /// Inside, and the mean round the section of the radial stress of the bore there, which is less
  /// by it but for what the cells leave [Pa].
  double pressure = 0., on_bore = 0.;
  /// Of the radial displacement a2 cos 2p + b2 sin 2p, and a3, b3; angles from the ring's a to b.
  std::array<double, 2> mode2{}, mode3{};
  /// On the inside and on the outside, at equal angles from 0 on.
  std::array<std::vector<WallStress>, 2> stress;

  double ovality(const double outer_diameter) const; ///< (largest - least diameter) / diameter
  double largest_mises(const unsigned int surface) const;
};

/**
 * The solution of a wall as a pipe has it, at each ring. Forces across a section are those that the
 * nodes of the layer beside it need, as the finite elements have them: integrals of the stress
 * times the shape functions of the section's nodes over that layer, less the loads in it. They are
 * in equilibrium with the loads to rounding, which stresses integrated over the section are to the
 * mesh's error only. The same on all processes.
 * @param stiffness that pressure adds, or null
 */
std::vector<RingState> wall_state(const PipeWall &wall, const WallLoads &loads,
                                  const ContinuumBody<3> &body, const ContinuumState &state,
                                  const PressureStiffness *const stiffness);

} // namespace frictionbeam
