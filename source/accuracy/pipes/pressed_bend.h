// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam::accuracy {

/// A bend of a thin wall.
struct ThinBend {
  double h = 0.;            ///< t R/r^2
  double radius_ratio = 0.; ///< R/r
  double poissons_ratio = 0.;
};

/**
 * How many times stiffer pressure makes the wall of a bend, by von Karman's energy of a long bend
 * with all terms. Its section moves by v = sum b_m sin m phi along the circumference, m = 2, 4, ..,
 * and -dv/dphi out of it; each m is coupled to the next, so that the least energy is a continued
 * fraction: k = 1/(1 - 9/(4 d_2)) times as flexible as a straight pipe, with
 * d_m = (1 + m^2)/2 + (lambda^2/12 (m^2 - 1) + psi) m^2 (m^2 - 1)
 *       - ((m - 1) (m + 3)/4)^2/d_(m+2),
 * lambda = h/sqrt(1 - nu^2), psi = (p/E) (R/r)^2 r/t. Within 3 % of solid walls, h from 0.1 to 0.5,
 * R/r = 3 and 10 (doc/solid.md, "Pressure that holds bends round"), of which the code's rule is up
 * to 22 % off.
 * @param strain p/E, of a pressure from inside
 */
double stiffer_by_pressure(const ThinBend &bend, const double strain);

} // namespace frictionbeam::accuracy
