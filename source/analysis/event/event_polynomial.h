// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace frictionbeam {

/// Coefficients of a polynomial on [0, 1], the constant first.
using Polynomial = Eigen::VectorXd;

double value(const Polynomial &p, const double x);
Polynomial derivative(const Polynomial &p);
Polynomial product(const Polynomial &p, const Polynomial &q);
/// Of p q from 0 to @p x.
double integral_of_product(const Polynomial &p, const Polynomial &q, const double x);
/// p(x y) as a polynomial in y.
void shorten(Polynomial &p, const double x);

/// What interpolated values are uncertain by, of each component.
struct InterpolationNoise {
  /// Found where halving the interval has not made the highest terms smaller. Cancellation, as in
  /// 1 - cos t at 0, makes it large beside the values.
  Eigen::VectorXd level;
  Eigen::VectorXd before;  ///< highest terms of the interval before; empty: the next is no half
  Eigen::VectorXd largest; ///< values of the interval at hand

  /// Of the values, their own rounding included.
  double of(const int component) const;
};

/**
 * The polynomial through a function's values at Chebyshev's points of [start, start + length], in
 * the part of that interval that has gone by; a column a component. @p smooth is made false if the
 * values are not those of a polynomial to rounding: the interval is too long then.
 * @param noise of intervals before; of this one too at exit
 */
Eigen::MatrixXd interpolate(const std::function<Eigen::VectorXd(const double)> &function,
                            const double start, const double length, InterpolationNoise &noise,
                            bool &smooth);

/// The polynomials of [begin, begin + length] of the interval of others, all of which that have
/// rows by order, in the part of it that has gone by.
Eigen::MatrixXd part_of(const Eigen::MatrixXd &rows, const double begin, const double length);

/**
 * The first x in [0, 1] at which p, positive until then, becomes negative; 2 if it never does. What
 * is within @p rounding of zero at 0 counts as zero there, and the next derivatives decide. The
 * motion behind p turns round at most a few times in [0, 1]: extrema are found by samples of the
 * derivative, so that two roots close together are not missed.
 */
double first_root(const Polynomial &p, const double rounding);

} // namespace frictionbeam
