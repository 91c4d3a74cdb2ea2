// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

/**
 * @file
 * What is kept of sections of pipes that yield or creep, plain data in SI units.
 */
namespace frictionbeam {

/// A section of a pipe that yields or creeps. Axes are the local ones of line.csv, along the route.
struct SectionState {
  unsigned int pipe = 0;
  double s = 0.;      ///< along the pipe [m]
  double length = 0.; ///< of pipe that it stands for [m]
  /// Those that cause stress: eps, gamma_y, gamma_z [-], chi, kappa_y, kappa_z [1/m].
  Motion strain{};
  /// In the wall: N, Vy, Vz [N], Mx, My, Mz [N m]. N is the beam's plus pressure times bore.
  Motion force{};
  double utilization = 0.; ///< equivalent stress over the yield stress that is reached by now
  double plastic_strain = 0., creep_strain = 0.; ///< accumulated, equivalent [-]
  double dissipated = 0.;                        ///< so far [J/m]
  double yield_strain = 0.;                      ///< where it begins to yield in tension [-]

  /// By which sections are compared: where most has flowed.
  double inelastic_strain() const { return plastic_strain + creep_strain; }
  /// Bent so far, a thin tube that does not harden has more than twice the curvature of first
  /// yield, and 96 % of its limit moment.
  bool is_hinge() const { return plastic_strain > yield_strain; }
};

/// What one section went through.
struct SectionHistory {
  std::string name;       ///< of the point that it stands at, or its pipe and place
  unsigned int every = 1; ///< of how many increments one is kept
  std::vector<double> time;
  std::vector<SectionState> states; ///< at these times
};

} // namespace frictionbeam
