// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/vibration/matched_record.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace frictionbeam {

namespace {

constexpr double pi = dealii::numbers::PI;
constexpr double good = 0.5;   ///< of what is allowed: no more iterations
constexpr double damped = 0.7; ///< of the correction in an iteration

/// Sum of waves within an envelope.
class Waves {
public:
  Waves(const MatchedRecordSettings &settings)
      : settings(settings), n_instants(std::lround(settings.duration / settings.step) + 1) {
    std::mt19937 random(settings.seed); // whose numbers are the same everywhere
    for (unsigned int j = 1; j <= settings.last * settings.duration * (1. + 1e-12); ++j) {
      const double f = j / settings.duration,
                   phase = 2. * pi * random() / 4294967296.; // drawn for all, so that 'first' may change
      if (f < settings.first / 1.2)
        continue;
      frequency.push_back(f);
      phases.push_back(phase);
    }
  }

  AccelerationRecord record(const std::vector<double> &amplitudes) const {
    AccelerationRecord result;
    result.acceleration.assign(n_instants, 0.);
    for (std::size_t j = 0; j < frequency.size(); ++j) {
      // cos((i + 1) d + p) = 2 cos(d) cos(i d + p) - cos((i - 1) d + p)
      const double d = 2. * pi * frequency[j] * settings.step, twice = 2. * std::cos(d);
      double before = amplitudes[j] * std::cos(phases[j] - d),
             now = amplitudes[j] * std::cos(phases[j]);
      for (unsigned int i = 0; i < n_instants; ++i) {
        result.acceleration[i] += now;
        const double next = twice * now - before;
        before = now;
        now = next;
      }
    }
    for (unsigned int i = 0; i < n_instants; ++i) {
      result.time.push_back(i * settings.step);
      result.acceleration[i] *= envelope(result.time[i]);
    }
    stop_at_end(result);
    return result;
  }

  std::vector<double> frequency;

private:
  double envelope(const double time) const {
    const double end = settings.duration - settings.fall;
    if (time < settings.rise)
      return std::pow(time / settings.rise, 2);
    return time > end ? std::pow(std::cos(pi / 2. * std::min(1., (time - end) / settings.fall)), 2)
                      : 1.;
  }

  /// Take off what is left of velocity and displacement at the end.
  void stop_at_end(AccelerationRecord &record) const {
    AccelerationRecord one = record, two = record; // the waves
    for (unsigned int i = 0; i < n_instants; ++i) {
      const double part = record.time[i] / record.time.back();
      one.acceleration[i] = std::pow(std::sin(pi * part), 2);
      two.acceleration[i] = std::sin(2. * pi * part);
    }
    const GroundMotion motion = integrate(record), of_one = integrate(one), of_two = integrate(two);
    const double v = motion.velocity.back(), u = motion.displacement.back(),
                 v1 = of_one.velocity.back(), u1 = of_one.displacement.back(),
                 v2 = of_two.velocity.back(), u2 = of_two.displacement.back(),
                 determinant = v1 * u2 - v2 * u1, a = (v * u2 - v2 * u) / determinant,
                 b = (v1 * u - v * u1) / determinant;
    for (unsigned int i = 0; i < n_instants; ++i)
      record.acceleration[i] -= a * one.acceleration[i] + b * two.acceleration[i];
  }

  const MatchedRecordSettings &settings;
  const unsigned int n_instants;
  std::vector<double> phases;
};

/// Straight over the logarithm of the frequency, level beyond the ends.
double interpolate(const std::vector<double> &x, const std::vector<double> &y, const double at) {
  const auto after = std::upper_bound(x.begin(), x.end(), at) - x.begin();
  if (after == 0)
    return y.front();
  if (after == static_cast<std::ptrdiff_t>(x.size()))
    return y.back();
  const double part = std::log(at / x[after - 1]) / std::log(x[after] / x[after - 1]);
  return y[after - 1] + part * (y[after] - y[after - 1]);
}

/// How far from 1 the ratios are, in terms of what is allowed below and above.
double miss(const MatchedRecord &record) {
  return std::max((1. - record.least) / 0.1, (record.largest - 1.) / 0.3);
}

/// The best record of the settings' seed.
MatchedRecord match_phases(const Spectrum &spectrum, const MatchedRecordSettings &settings) {
  const Waves waves(settings);
  MatchedRecord best, now;
  now.seed = settings.seed;
  now.frequency = logarithmic_steps(settings.first, settings.last, settings.n_frequencies);
  for (const double f : now.frequency)
    now.target.push_back(spectrum.at(f, settings.interpolation));
  std::vector<double> amplitudes;
  for (const double f : waves.frequency) // a white noise's response grows by the root of f
    amplitudes.push_back(spectrum.at(f, settings.interpolation) / std::sqrt(f * settings.duration));
  for (unsigned int i = 1; i <= settings.n_iterations; ++i) {
    now.iterations = i;
    now.record = waves.record(amplitudes);
    now.response.clear();
    std::vector<double> ratio;
    for (std::size_t k = 0; k < now.frequency.size(); ++k) {
      now.response.push_back(pseudo_acceleration(now.record, now.frequency[k], settings.damping));
      ratio.push_back(now.target[k] / now.response[k]);
    }
    // All of it louder or softer: what is below, over 0.1, and above, over 0.3, are equal then.
    const auto [low, high] = std::minmax_element(ratio.begin(), ratio.end());
    const double scale = 4. / (1. / *low + 3. / *high);
    for (double &value : now.record.acceleration)
      value *= scale;
    for (double &value : now.response)
      value *= scale;
    now.least = scale / *high;
    now.largest = scale / *low;
    if (best.iterations == 0 || miss(now) < miss(best))
      best = now;
    if (miss(best) < good)
      break;
    for (std::size_t j = 0; j < amplitudes.size(); ++j)
      amplitudes[j] *= std::pow(interpolate(now.frequency, ratio, waves.frequency[j]), damped);
  }
  return best;
}

} // namespace

void choose_free(const Spectrum &spectrum, MatchedRecordSettings &settings) {
  constexpr double highest = 50.;
  if (settings.first == 0.)
    settings.first = std::max(spectrum.curve.front().first, 2. / settings.duration);
  if (settings.last == 0.)
    settings.last = std::min(spectrum.curve.back().first, highest);
  if (settings.step == 0.)
    settings.step = std::min(0.01, 0.1 / settings.last);
  settings.step = settings.duration / std::ceil(settings.duration / settings.step * (1. - 1e-12));
}

MatchedRecord match_record(const Spectrum &spectrum, const MatchedRecordSettings &settings) {
  MatchedRecord best;
  MatchedRecordSettings one = settings;
  for (unsigned int i = 0; i < settings.n_seeds && (i == 0 || !best.fits()); ++i) {
    one.seed = settings.seed + i;
    const MatchedRecord record = match_phases(spectrum, one);
    if (i == 0 || miss(record) < miss(best))
      best = record;
  }
  return best;
}

} // namespace frictionbeam
