// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

/**
 * @file
 * The return to Coulomb's disc, plain C++ for laws and solvers alike.
 */
namespace frictionbeam {

/// std::hypot(x, y), quicker where no square leaves the range of numbers.
inline double length_of(const double x, const double y) {
  constexpr double least = 1e-280, most = 1e280;
  const double square = x * x + y * y;
  return square > least && square < most ? std::sqrt(square) : std::hypot(x, y);
}

/**
 * Nearest point T of the disc |T| <= radius to a trial point T* outside of it, in the norm of
 * diag(k)^-1:  T_i = T*_i / (1 + lambda k_i), with lambda > 0 from |T| = radius, and its
 * derivatives. With equal k it lies on the ray to T*.
 *
 * lambda comes from Newton's method on 1/|T| - 1/radius, nearly linear in lambda.
 */
struct DiscProjection {
  double point[2];
  double lambda;
  double by_trial[2][2]; ///< d point_i / d trial_j
  double by_radius[2];   ///< d point_i / d radius

  /// @param radius >= 0, @param k > 0
  DiscProjection(const double (&trial)[2], const double (&k)[2], const double radius) {
    const double size = length_of(trial[0], trial[1]);
    if (!(radius > 1e-100 * size)) { // as good as zero: the limit, T along k^-1 T*
      shrink_to_centre(trial, k);
      return;
    }
    lambda = (size / radius - 1.) / std::fmax(k[0], k[1]);
    if (k[0] == k[1]) {
      go_along_ray(trial, size, radius);
      return;
    }
    for (unsigned int iteration = 0; iteration < 100; ++iteration) {
      double norm2 = 0., slope = 0.;
      for (int i = 0; i < 2; ++i) {
        const double a = 1. + lambda * k[i], t = trial[i] / a;
        norm2 += t * t;
        slope += t * t * k[i] / a;
      }
      const double step = (std::sqrt(norm2) - radius) / radius * norm2 / slope;
      lambda += step;
      if (std::fabs(step) <= 1e-15 * lambda)
        break;
    }
    double shrinks[2], weight[2], sum = 0.; // 1 / (1 + lambda k_i); -d point_i / d lambda
    for (int i = 0; i < 2; ++i) {
      shrinks[i] = 1. / (1. + lambda * k[i]);
      point[i] = trial[i] * shrinks[i];
      weight[i] = k[i] * point[i] * shrinks[i];
      sum += point[i] * weight[i];
    }
    // |T| = radius fixes d lambda = (sum_j T_j/a_j dT*_j - radius d radius) / sum.
    for (int i = 0; i < 2; ++i) {
      const double share = weight[i] / sum;
      for (int j = 0; j < 2; ++j)
        by_trial[i][j] = (i == j ? shrinks[i] : 0.) - share * point[j] * shrinks[j];
      by_radius[i] = share * radius;
    }
  }

private:
  void go_along_ray(const double (&trial)[2], const double size, const double radius) {
    const double shrinks = radius / size;
    for (int i = 0; i < 2; ++i)
      by_radius[i] = trial[i] / size;
    for (int i = 0; i < 2; ++i) {
      point[i] = radius * by_radius[i];
      for (int j = 0; j < 2; ++j)
        by_trial[i][j] = shrinks * ((i == j ? 1. : 0.) - by_radius[i] * by_radius[j]);
    }
  }

  void shrink_to_centre(const double (&trial)[2], const double (&k)[2]) {
    const double size = std::hypot(trial[0] / k[0], trial[1] / k[1]);
    lambda = INFINITY;
    for (int i = 0; i < 2; ++i) {
      point[i] = by_trial[i][0] = by_trial[i][1] = 0.;
      by_radius[i] = trial[i] / k[i] / size;
    }
  }
};

} // namespace frictionbeam
