// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/spectra/acceleration_record.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

double AccelerationRecord::largest() const {
  double result = 0.;
  for (const double value : acceleration)
    result = std::max(result, std::abs(value));
  return result;
}

namespace {

/// An oscillator whose ground's acceleration goes straight from one value to another.
class Oscillator {
public:
  Oscillator(const double frequency, const double damping)
      : w(2. * dealii::numbers::PI * frequency), zeta(damping),
        damped(w * std::sqrt(1. - zeta * zeta)) {}

  double displacement = 0., velocity = 0.; ///< relative to the ground

  /// Go on by @p h with ground that accelerates from @p from by @p slope a second, and widen
  /// @p peak. @p start instant of it
  void advance(const double h, const double from, const double slope, const double start,
               OscillatorPeak &peak) {
    // u = A + B t + e^(-zeta w t) (C cos + D sin)
    B = -slope / (w * w);
    A = (-from - 2. * zeta * w * B) / (w * w);
    C = displacement - A;
    D = (velocity - B + zeta * w * C) / damped;
    const double u0 = displacement, v0 = velocity;
    move(h);
    const double size = std::max(std::abs(u0), std::abs(displacement)),
                 speed = std::max(std::abs(v0), std::abs(velocity));
    // Beyond both ends only where the velocity changes its sign, and not by much.
    if (v0 * velocity < 0. && size + speed * h > peak.displacement) {
      const double turn = find_turn(h, v0);
      widen(peak, u(turn), start + turn);
    }
    widen(peak, displacement, start + h);
  }

  /// So long that the motion bends little within.
  double longest_piece() const { return 0.1 / w; }

private:
  /// A record's pieces are equal but for the rounding of its instants.
  void move(const double t) {
    constexpr double rounding = 1e-11;
    if (!(std::abs(t - known) <= rounding * t)) {
      known = t;
      decay = std::exp(-zeta * w * t);
      cosine = std::cos(damped * t);
      sine = std::sin(damped * t);
    }
    displacement = A + B * t + decay * (C * cosine + D * sine);
    velocity = B + decay * ((damped * D - zeta * w * C) * cosine -
                            (damped * C + zeta * w * D) * sine);
  }
  double u(const double t) const {
    return A + B * t +
           std::exp(-zeta * w * t) * (C * std::cos(damped * t) + D * std::sin(damped * t));
  }
  double v(const double t) const {
    return B + std::exp(-zeta * w * t) * ((damped * D - zeta * w * C) * std::cos(damped * t) -
                                          (damped * C + zeta * w * D) * std::sin(damped * t));
  }
  /// Where the velocity is zero, by halving: it changes its sign between 0 and @p h.
  double find_turn(const double h, const double before) const {
    double low = 0., high = h;
    for (unsigned int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2.;
      (v(middle) * before > 0. ? low : high) = middle;
    }
    return (low + high) / 2.;
  }
  static void widen(OscillatorPeak &peak, const double value, const double time) {
    if (std::abs(value) > peak.displacement) {
      peak.displacement = std::abs(value);
      peak.at = time;
    }
  }

  const double w, zeta, damped;
  double A = 0., B = 0., C = 0., D = 0.;
  double known = -1., decay = 1., cosine = 1., sine = 0.; ///< of the piece before
};

} // namespace

OscillatorPeak largest_response(const AccelerationRecord &record, const double frequency,
                                const double damping) {
  Assert(frequency > 0. && damping >= 0. && damping < 1., dealii::ExcInternalError());
  AssertDimension(record.time.size(), record.acceleration.size());
  Oscillator oscillator(frequency, damping);
  OscillatorPeak peak;
  const auto go = [&](const double start, const double length, const double from,
                      const double slope) {
    const auto n =
        static_cast<unsigned int>(std::ceil(length / oscillator.longest_piece() * (1. - 1e-12)));
    const double h = length / std::max(n, 1u);
    for (unsigned int i = 0; i < std::max(n, 1u); ++i)
      oscillator.advance(h, from + slope * (i * h), slope, start + i * h, peak);
  };
  for (std::size_t i = 0; i + 1 < record.time.size(); ++i) {
    const double length = record.time[i + 1] - record.time[i];
    go(record.time[i], length, record.acceleration[i],
       (record.acceleration[i + 1] - record.acceleration[i]) / length);
  }
  go(record.time.back(), 1. / frequency, 0., 0.); // a full swing
  return peak;
}

double pseudo_acceleration(const AccelerationRecord &record, const double frequency,
                           const double damping) {
  return std::pow(2. * dealii::numbers::PI * frequency, 2) *
         largest_response(record, frequency, damping).displacement;
}

GroundMotion integrate(const AccelerationRecord &record) {
  GroundMotion motion;
  double v = 0., u = 0.;
  motion.velocity.push_back(v);
  motion.displacement.push_back(u);
  for (std::size_t i = 0; i + 1 < record.time.size(); ++i) {
    const double h = record.time[i + 1] - record.time[i], a0 = record.acceleration[i],
                 a1 = record.acceleration[i + 1];
    u += h * v + h * h * (2. * a0 + a1) / 6.;
    v += h * (a0 + a1) / 2.;
    motion.velocity.push_back(v);
    motion.displacement.push_back(u);
  }
  return motion;
}

std::vector<double> logarithmic_steps(const double first, const double last,
                                      const unsigned int n) {
  std::vector<double> result;
  for (unsigned int i = 0; i < n; ++i)
    result.push_back(i + 1 == n ? last : first * std::pow(last / first, i / (n - 1.)));
  return result;
}

} // namespace frictionbeam
