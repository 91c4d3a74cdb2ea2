// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_polynomial.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr int interpolation_degree = 14, n_samples = 24;
constexpr double pi = 3.14159265358979323846;
constexpr double rounding_of_values = 1e-15; ///< interpolated, of the largest

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// Chebyshev's points of [0, 1], ends included.
double chebyshev_point(const int i) { return (1. - std::cos(pi * i / interpolation_degree)) / 2.; }

/// From values at those points to Chebyshev coefficients, and from these to coefficients of powers.
struct Interpolation {
  Eigen::MatrixXd to_chebyshev, to_powers;

  Interpolation() {
    const int n = interpolation_degree + 1;
    LongMatrix vandermonde(n, n), chebyshev(n, n);
    for (int i = 0; i < n; ++i) {
      long double power = 1.;
      for (int k = 0; k < n; ++k) {
        vandermonde(i, k) = power;
        power *= chebyshev_point(i);
        chebyshev(i, k) =
            std::cos(static_cast<long double>(k) * std::acos(2.L * chebyshev_point(i) - 1.L));
      }
    }
    to_chebyshev = LongMatrix(chebyshev.fullPivLu().inverse()).cast<double>();
    to_powers = LongMatrix(vandermonde.fullPivLu().solve(chebyshev)).cast<double>();
  }
};

/// Root of p in [a, b] where p(a) >= 0 > p(b): Newton's method, kept inside by bisection.
double refine(const Polynomial &p, double a, double b) {
  const Polynomial slope = derivative(p);
  double x = (a + b) / 2.;
  for (unsigned int iteration = 0; iteration < 100; ++iteration) {
    const double f = value(p, x);
    (f >= 0. ? a : b) = x;
    if (b - a <= 1e-16)
      break;
    const double s = value(slope, x), newton = s != 0. ? x - f / s : a;
    const double next = newton > a && newton < b ? newton : (a + b) / 2.;
    if (next == x || std::abs(next - x) <= 1e-17)
      break;
    x = next;
  }
  return x;
}

} // namespace

double value(const Polynomial &p, const double x) {
  double result = 0.;
  for (Eigen::Index k = p.size(); k-- > 0;)
    result = result * x + p[k];
  return result;
}

Polynomial derivative(const Polynomial &p) {
  Polynomial result = Polynomial::Zero(std::max<Eigen::Index>(1, p.size() - 1));
  for (Eigen::Index k = 1; k < p.size(); ++k)
    result[k - 1] = k * p[k];
  return result;
}

Polynomial product(const Polynomial &p, const Polynomial &q) {
  Polynomial result = Polynomial::Zero(p.size() + q.size() - 1);
  for (Eigen::Index i = 0; i < p.size(); ++i)
    result.segment(i, q.size()) += p[i] * q;
  return result;
}

double integral_of_product(const Polynomial &p, const Polynomial &q, const double x) {
  const Polynomial all = product(p, q);
  double result = 0.;
  for (Eigen::Index k = all.size(); k-- > 0;)
    result = result * x + all[k] / (k + 1);
  return result * x;
}

void shorten(Polynomial &p, const double x) {
  double power = 1.;
  for (double &c : p) {
    c *= power;
    power *= x;
  }
}

double InterpolationNoise::of(const int component) const {
  return std::max(rounding_of_values * largest[component], level[component]);
}

Eigen::MatrixXd interpolate(const std::function<Eigen::VectorXd(const double)> &function,
                            const double start, const double length, InterpolationNoise &noise,
                            bool &smooth) {
  static const Interpolation interpolation;
  const int n = interpolation_degree + 1;
  const Eigen::VectorXd first = function(start);
  Eigen::MatrixXd values(n, first.size());
  for (int i = 0; i < n; ++i)
    values.row(i) = i == 0 ? first : function(start + chebyshev_point(i) * length);
  Eigen::MatrixXd coefficients = interpolation.to_chebyshev * values;
  if (noise.level.size() == 0)
    noise.level.setZero(values.cols());
  const bool halved = noise.before.size() > 0;
  if (!halved)
    noise.before.setZero(values.cols());
  noise.largest = values.cwiseAbs().colwise().maxCoeff();
  for (int c = 0; c < values.cols(); ++c) {
    const double largest = noise.largest[c],
                 last = coefficients.col(c).tail(3).lpNorm<Eigen::Infinity>();
    if (halved && last > 0.6 * noise.before[c] && last <= 1e-6 * largest) // a kink's are halved
      noise.level[c] = std::max(noise.level[c], last);
    noise.before[c] = last;
    smooth = smooth && last <= std::max(2e-14 * largest, 4. * noise.level[c]);
    // Rounding errors would be accelerations after two derivatives.
    for (int k = 1; k < n; ++k)
      if (std::abs(coefficients(k, c)) <= 4. * noise.of(c))
        coefficients(k, c) = 0.;
  }
  return interpolation.to_powers * coefficients;
}

Eigen::MatrixXd part_of(const Eigen::MatrixXd &rows, const double begin, const double length) {
  Eigen::MatrixXd result = rows;
  const Eigen::Index n = rows.rows();
  for (Eigen::Index j = 0; j + 1 < n && begin != 0.; ++j) // Horner's scheme
    for (Eigen::Index k = n - 1; k-- > j;)
      result.row(k) += begin * result.row(k + 1);
  double power = 1.;
  for (Eigen::Index k = 0; k < n; ++k, power *= length)
    result.row(k) *= power;
  return result;
}

double first_root(const Polynomial &p, const double rounding) {
  const double largest = p.size() > 0 ? p.lpNorm<Eigen::Infinity>() : 0.;
  if (largest <= rounding)
    return 2.;
  // Divide by x as often as p is zero at 0.
  Eigen::Index zeros = 0;
  double limit = rounding;
  while (zeros < p.size() && std::abs(p[zeros]) <= limit) {
    ++zeros;
    limit = std::max(rounding, 1e-9 * largest);
  }
  if (zeros == p.size())
    return 2.;
  const Polynomial rest = p.tail(p.size() - zeros);
  if (rest[0] < 0.)
    return 0.;
  if (rest[0] > rest.tail(rest.size() - 1).lpNorm<1>())
    return 2.;
  const Polynomial slope = derivative(rest), curvature = derivative(slope);
  double before = 0., slope_before = value(slope, 0.);
  for (int i = 1; i <= n_samples; ++i) {
    const double now = static_cast<double>(i) / n_samples, f = value(rest, now),
                 slope_now = value(slope, now);
    double turn = now;
    if (f >= 0. && slope_before < 0. && slope_now > 0.) // a minimum between
      turn = refine(-slope, before, now);
    if (value(rest, turn) < 0.)
      return refine(rest, before, turn);
    before = now;
    slope_before = slope_now;
  }
  return 2.;
}

} // namespace frictionbeam
