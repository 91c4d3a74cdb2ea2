// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "pipe_material.h"

namespace frictionbeam::section {

/**
 * The return to a yield surface that is a sphere in n stresses s,
 *   |s - H e| <= R(p),   de = dp (s - H e) / R,
 * e their plastic strains, of stiffness k without coupling: s = k (strain - e); k = 0 is a stress
 * that is given. The end of the increment is the nearest point in the elastic metric: each
 * component of s - H e is its trial value over 1 + (k + H) dp/R, and what is left is one equation
 * in dp.
 */
template <int n>
struct EllipsoidReturn {
  double xi[n]; ///< s - H e at the end
  double alpha[n];
  double dp = 0., lambda = 0., R; ///< lambda = dp/R
  bool converged = true;

  /// @param trial s - H e if nothing flows; @param p accumulated plastic strain at the start
  EllipsoidReturn(const Material &material, const double (&k)[n], const double (&trial)[n],
                  const double p) {
    R = material.yield(p);
    double S = at(material.H, k, trial);
    if (S <= R)
      return;
    // R / S - 1 = 0 is nearly straight in dp. It is negative at 0 and rises.
    double low = 0., high = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 200; ++i) {
      const double slope_of_R = material.slope(p + dp);
      double S_slope = 0.; // -S dS/dlambda
      for (int j = 0; j < n; ++j)
        S_slope += (k[j] + material.H) * xi[j] * xi[j] / alpha[j];
      const double residual = R / S - 1.;
      if (std::abs(residual) < 1e-15)
        return;
      (residual < 0. ? low : high) = dp;
      const double slope =
          slope_of_R / S + R * S_slope * (R - dp * slope_of_R) / (R * R * S * S * S);
      double next = dp - residual / slope;
      if (!(next > low && next < high))
        next = std::isinf(high) ? 2. * low : (low + high) / 2.;
      if (next == dp || next == low || next == high || std::abs(next - dp) < 1e-16 * dp)
        return;
      if (!std::isfinite(next) || next > 1e6)
        break; // no point of the surface bears what is given
      dp = next;
      R = material.yield(p + dp);
      lambda = dp / R;
      S = at(material.H, k, trial);
    }
    converged = false;
  }

  /// Stress by strain, where it flows: K (1 + lambda H)/alpha without coupling, less the product of
  /// direction() of two components over this; @p p at the end.
  double denominator(const Material &material, const double (&k)[n], const double p) const {
    const double slope = material.slope(p);
    double D = R * R * slope / (1. - lambda * slope);
    for (int i = 0; i < n; ++i)
      D += (k[i] + material.H) * xi[i] * xi[i] / alpha[i];
    return D;
  }
  double direction(const double (&k)[n], const int i) const { return k[i] * xi[i] / alpha[i]; }

private:
  /// s - H e at lambda; its norm.
  double at(const double H, const double (&k)[n], const double (&trial)[n]) {
    double sum = 0.;
    for (int i = 0; i < n; ++i) {
      alpha[i] = 1. + lambda * (k[i] + H);
      xi[i] = trial[i] / alpha[i];
      sum += xi[i] * xi[i];
    }
    return std::sqrt(sum);
  }
};

} // namespace frictionbeam::section
