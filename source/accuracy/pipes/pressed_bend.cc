// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/pipes/pressed_bend.h"

namespace frictionbeam::accuracy {

namespace {

/// How many times as flexible as a straight pipe. @param psi (p/E) (R/r)^2 r/t
double flexibility_of_long_bend(const ThinBend &bend, const double psi) {
  constexpr unsigned int last = 40; // of m: h > 0.01
  const double bending = bend.h * bend.h / (1. - bend.poissons_ratio * bend.poissons_ratio) / 12.;
  double of_next = 0.; // what is taken off d_m
  for (unsigned int m = last;; m -= 2) {
    const double m2 = m * m,
                 d = (1. + m2) / 2. + (bending * (m2 - 1.) + psi) * m2 * (m2 - 1.) - of_next;
    if (m == 2)
      return 1. / (1. - 9. / (4. * d));
    const double coupling = (m - 3.) * (m + 1.) / 4.; // of m - 2
    of_next = coupling * coupling / d;
  }
}

} // namespace

double stiffer_by_pressure(const ThinBend &bend, const double strain) {
  const double r_over_t = bend.radius_ratio / bend.h,
               psi = strain * bend.radius_ratio * bend.radius_ratio * r_over_t;
  return flexibility_of_long_bend(bend, 0.) / flexibility_of_long_bend(bend, psi);
}

} // namespace frictionbeam::accuracy
