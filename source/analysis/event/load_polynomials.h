// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/event/event_model.h"
#include "analysis/event/event_polynomial.h"

#include <algorithm>

namespace frictionbeam {

/// Instants this close are one [s]: a corner of a table that an instant of output misses by
/// rounding.
double same_instant(const double time);

/**
 * The loads' factors and the motions of the contacts' grounds as polynomials in time. They are
 * interpolated over intervals that outlast the pieces of a motion, which take their parts of them:
 * within an interval the ground then moves smoothly to rounding, however short pieces get, where
 * polynomials of their own would have velocities that jump by rounding over the length of a piece.
 */
class LoadPolynomials {
public:
  /// @param least time within which a load may do what it likes [s]
  LoadPolynomials(const EventModel &model, const double least) : model(model), least(least) {}

  /// Factors and grounds from @p time on. @param longest that an interval may be [s]
  /// @return the length that x = 1 stands for [s], @p length or less
  double expand(const LoadCourse &loads, const double time, const double length,
                const double longest);
  /// To a part of that length.
  void shorten(const double x);
  /// What rounding leaves of the rate of a load's factor [1/s], and of a component of the contacts'
  /// grounds [m/s].
  double rounding_of_factor_rate(const int load) const { return rate_of_noise(factor_noise, load); }
  double rounding_of_ground_rate(const int component) const {
    return rate_of_noise(ground_noise, component);
  }
  /// The instant as loads are to be asked for there: on this side of what jumps at an end.
  double within(const double time) const { return std::clamp(time, first_instant, last_instant); }
  void transfer(Archive &archive) {
    archive(start, end, guess, first_instant, last_instant, all_factors, all_ground);
    for (InterpolationNoise *const noise : {&factor_noise, &ground_noise})
      archive(noise->level, noise->before, noise->largest);
  }

  Eigen::MatrixXd factors, ground; ///< orders by load; orders by 3 contacts

private:
  void interpolate_from(const LoadCourse &loads, const double time, const double longest);
  bool interpolate_between(const LoadCourse &loads, const double length);
  double rate_of_noise(const InterpolationNoise &noise, const int column) const;

  const EventModel &model;
  const double least;
  double start = 0., end = 0., guess = 0.;      ///< of the interval [s]
  double first_instant = 0., last_instant = 0.; ///< of what is smooth, around it [s]
  Eigen::MatrixXd all_factors, all_ground;      ///< over the interval
  InterpolationNoise factor_noise, ground_noise;
};

} // namespace frictionbeam
