// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "ellipsoid_return.h"
#include "oval_pipe.h"

namespace frictionbeam::section {

/// Strains of a point of the wall in plane stress: along the pipe, round it, shear.
struct PointStrain {
  double along, round, shear;
};

/**
 * A point of the wall in plane stress, von Mises with Prager's and isotropic hardening:
 *   s = ((s_x + s_h)/2, sqrt(3)/2 (s_x - s_h), sqrt(3) tau),  |s - H e| <= R(p),
 * over the strains (e_x + e_h, (e_x - e_h)/sqrt(3), gamma/sqrt(3)), in which an isotropic metal is
 * three springs, E/(2(1 - nu)), 3G and 3G (J. C. Simo, R. L. Taylor, IJNME 22 (1986) 649-670,
 * doi:10.1002/nme.1620220310).
 */
struct OvalPoint {
  static constexpr double of_difference = 0.57735026918962576; // 1/sqrt(3)

  const OvalPipe &pipe;
  const double *old; ///< plastic strains, accumulated plastic strain
  double strain[3], trial[3];

  OvalPoint(const OvalPipe &pipe, const PointStrain &at, const double *old)
      : pipe(pipe), old(old), strain{at.along + at.round, of_difference * (at.along - at.round),
                                     of_difference * at.shear} {
    for (int i = 0; i < 3; ++i)
      trial[i] = pipe.stiffness[i] * (strain[i] - old[i]) - pipe.material.H * old[i];
  }

  /// Equivalent stress over the yield stress, if nothing flows.
  double utilization() const {
    return std::sqrt(trial[0] * trial[0] + trial[1] * trial[1] + trial[2] * trial[2]) /
           pipe.material.yield(old[3]);
  }
};

/// What a point answers at the end of an increment: stresses along (x), round (h) and of shear (t)
/// and their derivatives, which are symmetric.
struct PointResponse {
  double x, h, t, xx, xh, hh, xt, ht, tt;
  double equivalent;    ///< von Mises, less the back stress
  double rounding = 0.; ///< of the stress, which is a difference of strains
  bool converged;

  /// @param now gets the state
  PointResponse(const OvalPoint &point, double *now) {
    const double(&k)[3] = point.pipe.stiffness;
    const Material &material = point.pipe.material;
    const EllipsoidReturn<3> to(material, k, point.trial, point.old[3]);
    converged = to.converged;
    now[3] = point.old[3] + to.dp;
    double s[3], stiffness[3], direction[3] = {};
    for (int i = 0; i < 3; ++i) {
      now[i] = point.old[i] + to.lambda * to.xi[i];
      s[i] = to.xi[i] + material.H * now[i];
      stiffness[i] = k[i] * ((1. + to.lambda * material.H) / to.alpha[i] +
                             (to.dp > 0. ? least_stiffness : 0.));
      rounding = std::max(rounding, 2e-15 * k[i] * std::abs(point.strain[i]));
    }
    if (to.dp > 0.) {
      const double root = std::sqrt(to.denominator(material, k, now[3]));
      for (int i = 0; i < 3; ++i)
        direction[i] = to.direction(k, i) / root;
    }
    const auto by = [&](const int i, const int j) {
      return (i == j ? stiffness[i] : 0.) - direction[i] * direction[j];
    };
    equivalent = std::sqrt(to.xi[0] * to.xi[0] + to.xi[1] * to.xi[1] + to.xi[2] * to.xi[2]);
    // Along and round are the sum of s_0 and s_1/sqrt(3), and their difference.
    const double d = OvalPoint::of_difference, both = by(0, 0) + d * d * by(1, 1);
    x = s[0] + d * s[1];
    h = s[0] - d * s[1];
    t = d * s[2];
    xx = both + 2. * d * by(0, 1);
    hh = both - 2. * d * by(0, 1);
    xh = by(0, 0) - d * d * by(1, 1);
    xt = d * (by(0, 2) + d * by(1, 2));
    ht = d * (by(0, 2) - d * by(1, 2));
    tt = d * d * by(2, 2);
  }
};

/// Of a point per volume at the end of an increment [J/m3].
struct PointEnergy {
  double stored = 0., lost = 0.;

  PointEnergy(const OvalPoint &point, const double *now) {
    const Material &m = point.pipe.material;
    double squares = 0., old_squares = 0.;
    for (int i = 0; i < 3; ++i) {
      const double k = point.pipe.stiffness[i], s = k * (point.strain[i] - now[i]);
      stored += s * s / k / 2.;
      lost += s * (now[i] - point.old[i]);
      squares += now[i] * now[i];
      old_squares += point.old[i] * point.old[i];
    }
    const double hardening = m.H * squares / 2. + m.stored(now[3]);
    stored += hardening;
    lost -= hardening - m.H * old_squares / 2. - m.stored(point.old[3]);
    lost = now[3] > point.old[3] ? std::max(0., lost) : 0.;
  }
};

} // namespace frictionbeam::section
