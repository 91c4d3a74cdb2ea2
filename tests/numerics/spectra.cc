// SPDX-License-Identifier: LGPL-2.1-or-later
// Response spectra of records, records for spectra, and combinations of modes. Oscillators against
// closed forms of a step, a ramp and a sine; each combination against its formula written out for
// two modes and against what it must be in the limit.
#include "../check.h"

#include "analysis/vibration/matched_record.h"
#include "results/spectrum/modal_combination.h"

#include <functional>

using namespace frictionbeam;

namespace {

constexpr double pi = 3.14159265358979323846;

AccelerationRecord sampled(const double end, const double step,
                           const std::function<double(const double)> &a) {
  AccelerationRecord record;
  for (int i = 0; i <= std::lround(end / step); ++i) {
    record.time.push_back(i * step);
    record.acceleration.push_back(a(i * step));
  }
  return record;
}

void test_oscillators() {
  for (const double zeta : {0., 0.02, 0.3})
    for (const double f : {0.3, 2., 40.}) {
      // Of a step the first swing is the largest: 1 + exp(-zeta pi/sqrt(1 - zeta^2)) of the static
      // one.
      const double overshoot = 1. + std::exp(-zeta * pi / std::sqrt(1. - zeta * zeta));
      const AccelerationRecord step = {{0., 10.}, {3., 3.}};
      // The end of the step is another one, which adds up where nothing is damped: let it be long
      // enough to be quiet, or a whole number of periods, where the oscillator stands still.
      const AccelerationRecord whole = {{0., 12. / f}, {3., 3.}};
      CHECK_NEAR(pseudo_acceleration(zeta > 0.1 ? step : whole, f, zeta), 3. * overshoot, 1e-12);
      // The same cut into many pieces that are not a divisor of the period.
      const AccelerationRecord cut = sampled(12. / f, 12. / f / 1237., [](double) { return 3.; });
      CHECK_NEAR(pseudo_acceleration(cut, f, zeta), pseudo_acceleration(whole, f, zeta), 1e-11);
    }
  // A long piece of which the middle is passed over, and the same in many pieces.
  const AccelerationRecord slope = {{0., 30.}, {2., -1.}},
                           pieces = sampled(30., 0.05, [](const double t) { return 2. - 0.1 * t; });
  for (const double zeta : {0., 0.01, 0.5})
    CHECK_NEAR(pseudo_acceleration(slope, 3., zeta), pseudo_acceleration(pieces, 3., zeta), 1e-11);
  // An impulse, in the limit: w u -> velocity of the ground, and free vibration behind the record.
  const AccelerationRecord blow = {{0., 1e-5}, {100., 100.}};
  CHECK_NEAR(largest_response(blow, 1., 0.).displacement, 1e-3 / (2. * pi), 1e-9);
  // at a quarter of the period or half a one later, which are equal
  CHECK_NEAR(std::fmod(largest_response(blow, 1., 0.).at, 0.5), 0.25, 1e-4);
  // A sine, long enough to be steady: magnification 1/sqrt((1 - r^2)^2 + (2 zeta r)^2). The record
  // is straight between its instants, which takes (w h)^2/12 of it.
  const double zeta = 0.1, h = 1e-3;
  for (const double r : {0.5, 1., 1.7}) {
    const double f = 2. * r, steady = 1. / std::hypot(1. - r * r, 2. * zeta * r);
    const AccelerationRecord sine =
        sampled(40., h, [&](const double t) { return std::sin(2. * pi * f * t); });
    const double peak = pseudo_acceleration(sine, 2., zeta);
    CHECK(peak >= steady * (1. - 1e-4)); // the beginning may be more
    if (r == 1.)
      CHECK_NEAR(peak, steady * (1. - std::pow(2. * pi * f * h, 2) / 12.), 1e-6);
  }
  // Rigid and soft oscillators feel the ground's acceleration and displacement.
  const AccelerationRecord wave = sampled(
      5., 0.01, [](const double t) { return std::sin(2. * pi * t) * std::sin(pi * t / 5.); });
  CHECK_NEAR(pseudo_acceleration(wave, 500., 0.05), wave.largest(), 1e-3);
  double largest = 0.;
  for (const double u : integrate(wave).displacement)
    largest = std::max(largest, std::abs(u));
  CHECK_NEAR(largest_response(wave, 1e-3, 0.).displacement, largest, 1e-2);
  // a = 6 t: v = 3 t^2, u = t^3
  const GroundMotion ramp = integrate({{0., 0.5, 2.}, {0., 3., 12.}});
  CHECK_NEAR(ramp.velocity.back(), 12., 1e-14);
  CHECK_NEAR(ramp.displacement.back(), 8., 1e-14);
}

double combined(const SpectrumSettings::Modes how, const double one, const double other,
                const double f1, const double f2, const double damping = 0.05) {
  SpectrumSettings settings;
  settings.modes = how;
  settings.damping = damping;
  settings.duration = 10.;
  const Eigen::VectorXd a = Eigen::VectorXd::Constant(1, one),
                        b = Eigen::VectorXd::Constant(1, other);
  return combine_modes({a, b}, {f1, f2}, settings)[0];
}

void test_combinations() {
  using Modes = SpectrumSettings::Modes;
  CHECK_NEAR(combined(Modes::srss, 3., -4., 1., 1.), 5., 1e-15);
  CHECK_NEAR(combined(Modes::absolute, 3., -4., 1., 9.), 7., 1e-15);
  for (const Modes how : {Modes::grouping, Modes::ten_percent}) {
    CHECK_NEAR(combined(how, 3., -4., 1., 1.1), 7., 1e-15); // the limit belongs to it
    CHECK_NEAR(combined(how, 3., -4., 1., 1.1001), 5., 1e-15);
  }
  // Equal frequencies are one mode, far ones know nothing of each other.
  for (const Modes how : {Modes::cqc, Modes::signed_double_sum}) {
    CHECK_NEAR(combined(how, 3., 4., 2., 2.), 7., 1e-14);
    CHECK_NEAR(combined(how, 3., -4., 2., 2.), 1., 1e-7);
    CHECK_NEAR(combined(how, 3., -4., 1., 100., 1e-3), 5., 1e-2);
  }
  CHECK_NEAR(combined(Modes::double_sum, 3., -4., 2., 2.), 7., 1e-14);
  // rho and e written out
  const double r = 0.9, z = 0.05,
               rho = 8. * z * z * (1. + r) * std::pow(r, 1.5) /
                     (std::pow(1. - r * r, 2) + 4. * z * z * r * (1. + r) * (1. + r));
  CHECK_NEAR(combined(Modes::cqc, 3., -4., 0.9, 1.), std::sqrt(25. - 24. * rho), 1e-14);
  const double w1 = 2. * pi * 0.9, w2 = 2. * pi, z1 = z + 2. / (10. * w1), z2 = z + 2. / (10. * w2),
               apart = std::sqrt(1. - z * z) * (w1 - w2) / (z1 * w1 + z2 * w2),
               e = 1. / (1. + apart * apart);
  CHECK_NEAR(combined(Modes::double_sum, 3., -4., 0.9, 1.), std::sqrt(25. + 24. * e), 1e-14);
  CHECK_NEAR(combined(Modes::signed_double_sum, 3., -4., 0.9, 1.), std::sqrt(25. - 24. * e), 1e-14);
  CHECK_NEAR(double_sum_correlation(1., 0.9, z, 10.), double_sum_correlation(0.9, 1., z, 10.),
             1e-15);
  // Three modes in a chain: 1, 1.08, 1.16 Hz. A group begins at its lowest; pairs know no groups.
  SpectrumSettings settings;
  std::vector<Eigen::VectorXd> ones(3, Eigen::VectorXd::Ones(1));
  settings.modes = Modes::grouping;
  CHECK_NEAR(combine_modes(ones, {1., 1.08, 1.16}, settings)[0], std::sqrt(5.), 1e-15);
  settings.modes = Modes::ten_percent;
  CHECK_NEAR(combine_modes(ones, {1., 1.08, 1.16}, settings)[0], std::sqrt(7.), 1e-15);
  CHECK(combine_modes({}, {}, settings).size() == 0);
  // Rigid shares
  settings.rigid = SpectrumSettings::Rigid::lindley_yow;
  CHECK_NEAR(rigid_share(settings, 5., 8., 2.), 0.25, 1e-15);
  CHECK(rigid_share(settings, 5., 1., 2.) == 1.);
  settings.rigid = SpectrumSettings::Rigid::gupta;
  settings.rigid_frequencies = {{2., 32.}};
  CHECK(rigid_share(settings, 1., 8., 2.) == 0. && rigid_share(settings, 50., 8., 2.) == 1.);
  CHECK_NEAR(rigid_share(settings, 8., 8., 2.), 0.5, 1e-15);
}

/// A record fits its spectrum by a count of its own, comes to rest, and is the same again.
void test_matched_record() {
  Spectrum spectrum;
  spectrum.curve = {{1., 2.}, {3., 6.}, {9., 5.}, {20., 2.}};
  MatchedRecordSettings settings;
  settings.duration = 8.;
  settings.rise = 1.;
  settings.fall = 2.;
  settings.n_frequencies = 60;
  settings.interpolation = Spectrum::Interpolation::in_frequency;
  choose_free(spectrum, settings);
  const MatchedRecord match = match_record(spectrum, settings);
  CHECK(match.fits());
  CHECK(match.frequency.size() == 60 && match.frequency.front() == 1. &&
        match.frequency.back() == 20.);
  double least = 10., largest = 0.;
  for (const double f : match.frequency) {
    // the target by hand
    const auto &c = spectrum.curve;
    std::size_t i = 1;
    while (i + 1 < c.size() && c[i].first < f)
      ++i;
    const double target = c[i - 1].second + (c[i].second - c[i - 1].second) * (f - c[i - 1].first) /
                                                (c[i].first - c[i - 1].first),
                 ratio = pseudo_acceleration(match.record, f, 0.05) / target;
    least = std::min(least, ratio);
    largest = std::max(largest, ratio);
  }
  CHECK_NEAR(least, match.least, 1e-9);
  CHECK_NEAR(largest, match.largest, 1e-9);
  CHECK(least >= 0.9 && largest <= 1.3);
  const GroundMotion motion = integrate(match.record);
  CHECK(std::abs(motion.velocity.back()) < 1e-12 && std::abs(motion.displacement.back()) < 1e-12);
  CHECK(match_record(spectrum, settings).record.acceleration == match.record.acceleration);
  settings.seed = match.seed + 1;
  CHECK(match_record(spectrum, settings).record.acceleration != match.record.acceleration);
}

} // namespace

int spectra(int, char **) {
  test_oscillators();
  test_combinations();
  test_matched_record();
  return check::report();
}
