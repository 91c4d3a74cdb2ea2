// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/load_polynomials.h"

#include <cmath>

namespace frictionbeam {

namespace {

/// Rate at an end of a piece of length 1, of Chebyshev polynomials up to the 14th together.
constexpr double rate_of_interpolation = 2e3;
/// Rates of the ground come from differences of its motion: not from one within less than so many
/// of the least times, where it is smooth.
constexpr double wide = 1e6;

} // namespace

double same_instant(const double time) { return 1e-12 * std::abs(time); }

double LoadPolynomials::rate_of_noise(const InterpolationNoise &noise, const int column) const {
  return noise.largest.size() > 0 ? rate_of_interpolation * noise.of(column) / (end - start) : 0.;
}

double LoadPolynomials::expand(const LoadCourse &loads, const double time, const double length,
                               const double longest) {
  const double left = time >= start ? end - time : 0.;
  if (left < length / 2. || left <= same_instant(time))
    interpolate_from(loads, time, longest);
  const double part = std::min(length, end - time), whole = end - start;
  factors = part_of(all_factors, (time - start) / whole, part / whole);
  ground = part_of(all_ground, (time - start) / whole, part / whole);
  return part;
}

void LoadPolynomials::shorten(const double x) {
  for (Eigen::MatrixXd *const m : {&factors, &ground})
    *m = part_of(*m, 0., x);
}

void LoadPolynomials::interpolate_from(const LoadCourse &loads, const double time,
                                       const double longest) {
  // A jump at the end belongs to the next interval, and one at the start is over.
  const double same = same_instant(time), next = loads.next_break(time - same);
  first_instant = next <= time + same ? std::nextafter(next, next + 1.) : time;
  last_instant = std::nextafter(loads.next_break(time + same), time);
  double whole = std::max(longest, std::min(wide * least, last_instant - time));
  if (guess > 0.)
    whole = std::min(whole, 2. * guess);
  factor_noise.before.resize(0);
  ground_noise.before.resize(0);
  start = time;
  while (!interpolate_between(loads, whole) && whole > least)
    whole /= 2.;
  guess = whole;
  end = start + whole;
}

bool LoadPolynomials::interpolate_between(const LoadCourse &loads, const double length) {
  bool smooth = true;
  const auto powers = [&](InterpolationNoise &noise,
                          const std::function<Vector(const double)> &function) {
    return interpolate([&](const double t) { return function(within(t)); }, start, length, noise,
                       smooth);
  };
  all_factors = powers(factor_noise, [&](const double t) {
    const LoadCourse::Factors f =
        t < last_instant ? loads.factors(t)
                         : loads.factors_before(std::nextafter(last_instant, last_instant + 1.));
    return Vector(Eigen::Map<const Vector>(f.data(), f.size()));
  });
  if (model.ground_moves)
    all_ground = powers(
        ground_noise, [&](const double t) { return model.ground_displacement(loads.imposed(t)); });
  else
    all_ground = Eigen::MatrixXd::Zero(1, 3 * model.contacts.size());
  return smooth;
}

} // namespace frictionbeam
