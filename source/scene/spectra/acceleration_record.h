// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace frictionbeam {

/// The acceleration of the ground at instants, straight between them.
struct AccelerationRecord {
  std::vector<double> time;         ///< rising, at least two [s]
  std::vector<double> acceleration; ///< [m/s2]

  double largest() const; ///< size [m/s2]
};

/// What an oscillator on that ground does at most, in size.
struct OscillatorPeak {
  double displacement = 0.; ///< relative to the ground [m]
  double at = 0.;           ///< instant of it [s]
};

/**
 * The largest motion of u'' + 2 zeta w u' + w^2 u = -a(t) from rest, during the record and in the
 * free vibration behind it. Exact: over each piece of the record u is known in closed form (N. C.
 * Nigam, P. C. Jennings, Bulletin of the Seismological Society of America 59 (1969) 909-922), and
 * the extremes lie where the velocity changes its sign, found to rounding.
 * @param frequency w/(2 pi) [Hz], > 0
 * @param damping zeta, ratio, 0 <= zeta < 1
 */
OscillatorPeak largest_response(const AccelerationRecord &record, const double frequency,
                                const double damping);

/// Pseudo-acceleration w^2 |u|, the ordinate of a response spectrum [m/s2].
double pseudo_acceleration(const AccelerationRecord &record, const double frequency,
                           const double damping);

/// Velocity and displacement of the ground at the record's instants, from rest; of a ground whose
/// acceleration is straight between them [m/s, m].
struct GroundMotion {
  std::vector<double> velocity, displacement;
};
GroundMotion integrate(const AccelerationRecord &record);

/// From @p first to @p last, both included, in equal steps on a logarithmic axis.
std::vector<double> logarithmic_steps(const double first, const double last, const unsigned int n);

} // namespace frictionbeam
