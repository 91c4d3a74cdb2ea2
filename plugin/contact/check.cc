// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/check.h>
#include <frictionbeam/disc_projection.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam::contact {

void Check::include(const Check &other) {
  natural_map = std::max(natural_map, other.natural_map);
  penetration = std::max(penetration, other.penetration);
  cone_violation = std::max(cone_violation, other.cone_violation);
  slip_angle = std::max(slip_angle, other.slip_angle);
  least_dissipation = std::min(least_dissipation, other.least_dissipation);
}

void Check::judge(const Point &point, const double largest) {
  const double P = point.P, rounding = point.rounding, rho_n = point.normal_scale,
               rho_t = point.shear_scale;
  const double *const T = point.T, *const slip = point.slip;
  const auto beyond = [](const double misfit, const double excused) {
    return std::max(0., std::abs(misfit) - excused);
  };
  const double normal = beyond(P - std::max(0., P - rho_n * point.gap), rho_n * rounding);
  double moved[2] = {T[0] + rho_t * slip[0], T[1] + rho_t * slip[1]};
  const double radius = point.friction * P, size = length_of(moved[0], moved[1]);
  if (size > radius)
    for (double &m : moved)
      m *= radius / size;
  const double shear = beyond(length_of(T[0] - moved[0], T[1] - moved[1]), rho_t * rounding);
  const double friction_force = length_of(T[0], T[1]), path = length_of(slip[0], slip[1]);
  // Its slip is no scale: rho_T times a slip may be 1e6 times the friction force.
  const double scale =
      std::max({length_of(P, friction_force), std::abs(rho_n * point.gap), 1e-12 * largest});
  if (scale > 0.)
    natural_map = std::max(natural_map, length_of(normal, shear) / scale);
  penetration = std::max(penetration, -point.gap);
  cone_violation =
      std::max(cone_violation, (friction_force - radius) / std::max(P, 1e-12 * largest));
  if (P > 0. && path > 1e4 * rounding &&
      std::min(friction_force, rho_t * path) > 1e-4 * std::max(scale, rho_t * path)) {
    const double cross = slip[0] * T[1] - slip[1] * T[0], dot = slip[0] * T[0] + slip[1] * T[1];
    slip_angle = std::max(slip_angle, std::abs(std::atan2(cross, dot)));
  }
}

} // namespace frictionbeam::contact
