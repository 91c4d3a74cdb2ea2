// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomials of the event integrator: arithmetic, interpolation to rounding, and first roots, with
// those that touch zero, lie close together, or are at the beginning.
#include "../check.h"

#include "analysis/event/event_polynomial.h"

using namespace frictionbeam;

namespace {

Polynomial polynomial(const std::initializer_list<double> coefficients) {
  Polynomial p(coefficients.size());
  std::copy(coefficients.begin(), coefficients.end(), p.begin());
  return p;
}

/// (x - a)(x - b) times @p factor.
Polynomial with_roots(const double a, const double b, const double factor = 1.) {
  return polynomial({factor * a * b, -factor * (a + b), factor});
}

void interpolates(const double length, const bool smooth_expected) {
  InterpolationNoise noise;
  bool smooth = true;
  const Eigen::MatrixXd rows =
      interpolate([](const double t) { return Eigen::Vector2d(std::sin(3. * t), std::exp(-t)); },
                  0.7, length, noise, smooth);
  CHECK(smooth == smooth_expected);
  if (!smooth)
    return;
  for (const double x : {0., 0.3, 1.}) {
    const double t = 0.7 + x * length;
    const Polynomial sine = rows.col(0), decay = rows.col(1);
    CHECK_NEAR(value(sine, x), std::sin(3. * t), 1e-12);
    CHECK_NEAR(value(decay, x), std::exp(-t), 1e-12);
    const Eigen::MatrixXd rest = part_of(rows, 0.25, 0.5);
    CHECK_NEAR(value(Polynomial(rest.col(0)), x), value(sine, 0.25 + 0.5 * x), 1e-14);
    CHECK_NEAR(value(derivative(rest.col(1)), x), 0.5 * value(derivative(decay), 0.25 + 0.5 * x),
               1e-13);
  }
}

} // namespace

int polynomials(int, char **) {
  const Polynomial p = polynomial({1., -2., 3.}), q = polynomial({0., 1., 0., 4.});
  CHECK_NEAR(value(p, 0.5), 0.75, 1e-15);
  CHECK_NEAR(value(derivative(q), 0.5), 4., 1e-15);
  CHECK_NEAR(value(product(p, q), 0.3), value(p, 0.3) * value(q, 0.3), 1e-14);
  // (1 - 2x + 3x^2)(x + 4x^3) from 0 to 1: 1/2 - 2/3 + 7/4 - 8/5 + 2
  CHECK_NEAR(integral_of_product(p, q, 1.), 0.5 - 2. / 3. + 1.75 - 1.6 + 2., 1e-14);
  Polynomial shorter = p;
  shorten(shorter, 0.25);
  CHECK_NEAR(value(shorter, 0.8), value(p, 0.2), 1e-15);

  interpolates(0.5, true);
  interpolates(50., false); // 24 periods are no polynomial of such an order

  const double eps = 1e-13;
  CHECK_NEAR(first_root(polynomial({0.25, -1.}), eps), 0.25, 1e-12);
  CHECK(first_root(polynomial({1., 1.}), eps) == 2.);
  CHECK(first_root(polynomial({1., -0.9}), eps) == 2.); // beyond the interval
  CHECK_NEAR(first_root(with_roots(0.4, 0.6), eps), 0.4, 1e-12);
  CHECK_NEAR(first_root(with_roots(0.5, 0.5 + 1e-5), eps), 0.5, 1e-9);
  CHECK(first_root(product(with_roots(0.5, 0.5), polynomial({1., 1.})) +
                       polynomial({1e-6, 0., 0., 0.}),
                   eps) == 2.); // turns round above zero
  CHECK(first_root(polynomial({0., -1.}), eps) == 0.);
  CHECK(first_root(polynomial({0., 1.}), eps) == 2.);
  CHECK(first_root(polynomial({1e-15, 0., -1.}), eps) == 0.); // zero to rounding, then falls
  CHECK_NEAR(first_root(polynomial({0., 1., -2.}), eps), 0.5, 1e-12);
  return check::report();
}
