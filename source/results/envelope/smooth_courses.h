// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace frictionbeam {

/**
 * Smooth functions of time on [begin, end], by the polynomials through their values in Chebyshev's
 * points, the ends among them: 5, 9, 17 or 33, as many as it takes until the last coefficients are
 * below 1e-12 of the largest. Extremes and integrals are those of the polynomials (Clenshaw and
 * Curtis, doi:10.1007/BF01386223).
 */
class SmoothCourses {
public:
  using Functions = std::function<Eigen::VectorXd(const double time)>;
  struct Extreme {
    double time = 0., value = 0.;
  };

  /// @param sizes of the functions, of which 1e-12 is rounding too; empty if not known
  /// @param is_enough asked before points are added; may be empty
  SmoothCourses(const Functions &functions, const double begin, const double end,
                const Eigen::VectorXd &sizes = {},
                const std::function<bool(const SmoothCourses &)> &is_enough = {});

  double value(const unsigned int function, const double time) const;
  /// All functions at one instant, which costs less in the points.
  class Instant {
  public:
    Instant(const SmoothCourses &courses, const double time) : courses(courses), time(time) {}
    Instant(const SmoothCourses &courses, const int point) : courses(courses), point(point) {}
    double operator[](const unsigned int function) const {
      return point >= 0 ? courses.values(function, point) : courses.value(function, time);
    }

  private:
    const SmoothCourses &courses;
    double time = 0.;
    int point = -1;
  };
  /// The points, from begin to end.
  int n_points() const { return values.cols(); }
  double instant(const int point) const { return instant(point, n_points() - 1); }
  /// The largest value in [from, to], if it is above @p bound; with @p sign = -1 the smallest
  /// below.
  std::optional<Extreme> extreme(const unsigned int function, const double sign, const double from,
                                 const double to, const double bound) const;
  /// Whether it may be larger than @p bound somewhere; with @p sign = -1 smaller. Known with five
  /// points already, if they show the course at all.
  bool may_exceed(const unsigned int function, const double sign, const double bound) const;
  /// Between which values its size is, as far as may_exceed() knows.
  double reach(const unsigned int function) const;
  double floor(const unsigned int function) const;
  double integral(const unsigned int function, const double from, const double to) const;
  /// Instants in (from, to) at which the function changes its sign.
  std::vector<double> zeros(const unsigned int function, const double from, const double to) const;
  /// Largest absolute value in the points.
  double size(const unsigned int function) const {
    return values.row(function).cwiseAbs().maxCoeff();
  }

private:
  double place(const double time) const { return (2. * time - begin - end) / (end - begin); }
  double instant(const int i, const int n) const;
  bool interpolate(const Eigen::VectorXd &sizes);

  double begin, end;
  Eigen::MatrixXd values;       ///< by function and point, from begin to end
  Eigen::MatrixXd coefficients; ///< of Chebyshev's polynomials, a column a function
};

} // namespace frictionbeam
