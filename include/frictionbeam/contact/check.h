// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam::contact {

/// How far contacts are from Signorini's condition and Coulomb's law, each on its own scale.
struct Check {
  /// Largest natural-map residual |r - P(r - rho u)| / max(|r|, rho |u|, 1e-12 of the largest
  /// force), beyond what rounding of the displacements makes of it.
  double natural_map = 0.;
  double penetration = 0.;    ///< largest, rigid part [m]
  double cone_violation = 0.; ///< largest (|T| - f N) / max(N, 1e-12 of the largest force)
  /// Largest angle between slip and friction force, where slip is above rounding and both, rho
  /// |slip| and |T|, are above 1e-4 of the contact's scale [rad].
  double slip_angle = 0.;
  double least_dissipation = 0.; ///< of one contact in the increment, at most 0 [J]

  /// Whether the contact laws hold: natural map and cone to the tolerance, slip within a
  /// milliradian of the friction force, and so no dissipation below zero.
  bool holds(const double tolerance) const {
    return natural_map <= tolerance && cone_violation <= tolerance && slip_angle <= 1e-3;
  }
  /// The worst of both.
  void include(const Check &other);

  /// One contact with compression P, friction force T, gap of the rigid part, slip of the
  /// increment.
  struct Point {
    double P, T[2]; ///< [N]
    double gap, slip[2];
    double friction;                  ///< coefficient
    double normal_scale, shear_scale; ///< rho_N, rho_T [N/m]
    double rounding;                  ///< of gap and slip
  };
  /// @param largest force of all contacts
  void judge(const Point &point, const double largest);
};

} // namespace frictionbeam::contact
