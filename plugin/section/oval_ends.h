// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace frictionbeam::section {

/**
 * What the ends of a bend between long straight pipes leave of its ovalisation. An oval that
 * changes along a pipe warps its sections (no hoop and no shear strain of the wall: V. Z. Vlasov's
 * semi-membrane theory): with a = a_2(s) the axial strain is -(r/4) a'' cos 2 phi. So under a
 * constant moment
 *
 *   B a'''' + K a = K a_long,   B = E pi r t (r/4)^2,
 *
 * in the bend, K what a bend of no end has (decay beta = (K/4B)^(1/4)), and the same without load
 * in the straight pipes, whose K is that of the ring alone (gamma): there a'' + 2 gamma a' +
 * 2 gamma^2 a = 0 and a''' = 2 gamma^2 a' + 4 gamma^3 a, outwards.
 */
class OvalEnds {
public:
  /// @param length of the bend [m]; @param beta, gamma decay in the bend and beyond [1/m]
  OvalEnds(const double length, const double beta, const double gamma)
      : scaled(std::max(beta * length, shortest)) {
    // a = 1 + P (f(x) + f(L - x)) + Q (g(x) + g(L - x)), f = exp(-x) cos x, g = exp(-x) sin x.
    const double c = gamma / beta, E = std::exp(-scaled), C = E * std::cos(scaled),
                 S = E * std::sin(scaled);
    // Of the sums of f and of g at x = 0: value and derivatives outwards.
    const double of_f[4] = {1. + C, 1. - C - S, 2. * S, -2. + 2. * (C - S)},
                 of_g[4] = {S, -1. + C - S, -2. - 2. * C, -2. + 2. * (C + S)};
    const auto moment = [&](const double *d) { return d[2] + 2. * c * d[1] + 2. * c * c * d[0]; };
    const auto force = [&](const double *d) {
      return d[3] - 2. * c * c * d[1] - 4. * c * c * c * d[0];
    };
    const double right[2] = {-2. * c * c, 4. * c * c * c};
    const double determinant = moment(of_f) * force(of_g) - moment(of_g) * force(of_f);
    P = (right[0] * force(of_g) - moment(of_g) * right[1]) / determinant;
    Q = (moment(of_f) * right[1] - right[0] * force(of_f)) / determinant;
  }

  /// a over that of a bend of no end, at a part of the way.
  double share(const double place) const {
    return 1. + of(place * scaled) + of((1. - place) * scaled);
  }

private:
  static constexpr double shortest = 1e-2; ///< over 1/beta: what is shorter has no digits
  double of(const double x) const { return std::exp(-x) * (P * std::cos(x) + Q * std::sin(x)); }

  double scaled, P, Q; ///< length in units of 1/beta; factors
};

} // namespace frictionbeam::section
