// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/envelope/smooth_courses.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr int first_degree = 4, last_degree = 32;
constexpr double rounding_of_coefficients = 1e-12, pi = 3.14159265358979323846;

/// Values in Chebyshev's points to coefficients, exact for the degree.
Eigen::MatrixXd transformation(const int n) {
  Eigen::MatrixXd result(n + 1, n + 1); // point by coefficient
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k) {
      const double half = (i == 0 || i == n ? 0.5 : 1.) * (k == 0 || k == n ? 0.5 : 1.);
      result(i, k) = 2. * half / n * std::cos(pi * k * (n - i) / n);
    }
  return result;
}

const Eigen::MatrixXd &transformation_of(const int n) {
  static const std::vector<Eigen::MatrixXd> all = {transformation(4), transformation(8),
                                                   transformation(16), transformation(32)};
  return all[n == 4 ? 0 : n == 8 ? 1 : n == 16 ? 2 : 3];
}

/// Sum of c_k T_k(x), by Clenshaw's recurrence.
double sum(const Eigen::Ref<const Eigen::VectorXd> &c, const double x) {
  double b1 = 0., b2 = 0.;
  for (Eigen::Index k = c.size(); k-- > 1;) {
    const double b = c[k] + 2. * x * b1 - b2;
    b2 = b1;
    b1 = b;
  }
  return c[0] + x * b1 - b2;
}

/// By how much a course may differ from its mean coefficient, if these coefficients show it at all.
double spread(const Eigen::Ref<const Eigen::VectorXd> &c) {
  constexpr double of_the_rest = 10.; // of the last two coefficients
  return c.tail(c.size() - 1).lpNorm<1>() + of_the_rest * c.tail(2).lpNorm<1>();
}

/// Where the sum changes its sign in (a, b), by samples and bisection.
std::vector<double> changes_of_sign(const Eigen::VectorXd &c, const double a, const double b) {
  const int n_samples = 4 * c.size();
  std::vector<double> result;
  double before = a, value_before = sum(c, a);
  for (int i = 1; i <= n_samples; ++i) {
    const double x = a + (b - a) * i / n_samples, value = sum(c, x);
    if ((value_before > 0. && value < 0.) || (value_before < 0. && value > 0.)) {
      double low = before, high = x;
      for (int k = 0; k < 60 && high - low > 1e-16; ++k) {
        const double middle = (low + high) / 2.;
        ((sum(c, middle) > 0.) == (value_before > 0.) ? low : high) = middle;
      }
      result.push_back((low + high) / 2.);
    }
    if (value != 0.) {
      before = x;
      value_before = value;
    }
  }
  return result;
}

/// Of the derivative in x.
Eigen::VectorXd derived(const Eigen::VectorXd &c) {
  const Eigen::Index n = c.size() - 1;
  Eigen::VectorXd d = Eigen::VectorXd::Zero(n + 2);
  for (Eigen::Index k = n; k >= 1; --k)
    d[k - 1] = d[k + 1] + 2. * k * c[k];
  d[0] /= 2.;
  return d.head(std::max<Eigen::Index>(n, 1));
}

/// Of the integral from -1.
Eigen::VectorXd integrated(const Eigen::VectorXd &c) {
  const Eigen::Index n = c.size() - 1;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(n + 2);
  for (Eigen::Index k = 0; k <= n; ++k) {
    result[k + 1] += (k == 0 ? 1. : 0.5 / (k + 1)) * c[k];
    if (k >= 2)
      result[k - 1] -= 0.5 / (k - 1) * c[k];
  }
  result[0] -= sum(result, -1.);
  return result;
}

} // namespace

SmoothCourses::SmoothCourses(const Functions &functions, const double begin, const double end,
                             const Eigen::VectorXd &sizes,
                             const std::function<bool(const SmoothCourses &)> &is_enough)
    : begin(begin), end(end) {
  for (int n = first_degree;; n *= 2) {
    Eigen::MatrixXd finer;
    for (int i = 0; i <= n; ++i) {
      const bool is_known = values.cols() > 0 && i % 2 == 0;
      const Eigen::VectorXd column =
          is_known ? Eigen::VectorXd(values.col(i / 2)) : functions(instant(i, n));
      if (i == 0)
        finer.resize(column.size(), n + 1);
      finer.col(i) = column;
    }
    values = finer;
    if (interpolate(sizes) || n == last_degree || (is_enough && is_enough(*this)))
      return;
  }
}

double SmoothCourses::instant(const int i, const int n) const {
  return i == 0 ? begin : i == n ? end : begin + (end - begin) * (1. - std::cos(pi * i / n)) / 2.;
}

bool SmoothCourses::interpolate(const Eigen::VectorXd &sizes) {
  coefficients = (values * transformation_of(values.cols() - 1)).transpose();
  for (Eigen::Index f = 0; f < coefficients.cols(); ++f) {
    const double largest =
        std::max(coefficients.col(f).lpNorm<Eigen::Infinity>(), sizes.size() > 0 ? sizes[f] : 0.);
    if (!(coefficients.col(f).tail(2).lpNorm<Eigen::Infinity>() <=
          rounding_of_coefficients * largest))
      return false;
  }
  return true;
}

double SmoothCourses::value(const unsigned int function, const double time) const {
  return sum(coefficients.col(function), place(time));
}

std::optional<SmoothCourses::Extreme> SmoothCourses::extreme(const unsigned int function,
                                                             const double sign, const double from,
                                                             const double to,
                                                             const double bound) const {
  const Eigen::VectorXd c = sign * coefficients.col(function);
  if (!(c[0] + c.tail(c.size() - 1).lpNorm<1>() > sign * bound))
    return {};
  const double a = place(from), b = place(to);
  double best_x = a, best = sum(c, a);
  const auto take = [&](const double x) {
    if (const double here = sum(c, x); here > best) {
      best = here;
      best_x = x;
    }
  };
  take(b);
  for (const double x : changes_of_sign(derived(c), a, b))
    take(x);
  if (!(best > sign * bound))
    return {};
  return Extreme{begin + (best_x + 1.) / 2. * (end - begin), sign * best};
}

bool SmoothCourses::may_exceed(const unsigned int function, const double sign,
                               const double bound) const {
  const auto c = coefficients.col(function);
  return !(sign * c[0] + spread(c) <= sign * bound);
}

double SmoothCourses::reach(const unsigned int function) const {
  const auto c = coefficients.col(function);
  return std::abs(c[0]) + spread(c);
}

double SmoothCourses::floor(const unsigned int function) const {
  const auto c = coefficients.col(function);
  return std::max(0., std::abs(c[0]) - spread(c));
}

std::vector<double> SmoothCourses::zeros(const unsigned int function, const double from,
                                         const double to) const {
  std::vector<double> result;
  for (const double x : changes_of_sign(coefficients.col(function), place(from), place(to)))
    result.push_back(begin + (x + 1.) / 2. * (end - begin));
  return result;
}

double SmoothCourses::integral(const unsigned int function, const double from,
                               const double to) const {
  const Eigen::VectorXd whole = integrated(coefficients.col(function));
  return (end - begin) / 2. * (sum(whole, place(to)) - sum(whole, place(from)));
}

} // namespace frictionbeam
