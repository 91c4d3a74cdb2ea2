// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam::accuracy {

/// What the flexibility of a bend's solid wall depends on.
struct BendShape {
  double h = 0.;            ///< t R/r^2
  double radius_ratio = 0.; ///< R/r
  double angle = 0.;        ///< [rad]
  double tangent = 0.;      ///< shorter of the straight runs beside it [outer diameters]
};

/// By moments in the bend's plane, and across it.
struct BendRatios {
  double in_plane = 1., across = 1.;
  double off = 0.; ///< part that they may be off
};

/**
 * Flexibility of solid bends over 1.65/h, by the measured table of doc/solid.md ("Flexibility of
 * bends": nu = 0.3, R/r = 3, 6 and 10, angles of 45 and 90 degrees, h from 0.1 to 1, tangents of 1
 * and 4 diameters), linear in log h, log R/r, 1/angle and the tangents, level beyond; 1/angle is
 * extrapolated down to 22.5 degrees. Within 4 % of measured bends between (R/r = 2; 30 degrees: too
 * stiff by 7 to 15 %).
 */
BendRatios ratios_of_walls(const BendShape &bend);

/// r sqrt(r/t) of straight pipe that a solid part takes beside a bend, if there are as many.
inline constexpr double longest_cut = 2.;

/**
 * Part of a bend's flexibility that one cut through the straight pipe beside it adds, after so many
 * r sqrt(r/t), which leaves its oval free there: the most of bends of 90 degrees with h from 0.06
 * to 0.4, and (90/angle)^0.6 times that (doc/solid.md, "How much straight pipe").
 * @param angle [rad]
 */
double added_by_cut(const double lengths, const double angle);

} // namespace frictionbeam::accuracy
