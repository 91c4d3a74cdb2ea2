// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam::section {

/// Places of the parameters of creep within their own list.
enum CreepParameter {
  creep_coefficient,
  creep_exponent,
  primary_coefficient,
  primary_exponent,
  primary_time_exponent,
  primary_hardening,
  activation,
  reference_temperature,
  n_creep_parameters
};

constexpr LawParameter creep_parameters[n_creep_parameters] = {
    {"Creep coefficient", "1/(Pa^n s)", 0., 0., 1e300,
     "B of the creep rate B s^n, s in Pa whatever the units; 0: none"},
    {"Creep exponent", "-", 1., 1., 100., "n"},
    {"Primary creep coefficient", "1/(Pa^k s^m)", 0., 0., 1e300,
     "C of the creep strain C s^k t^m at constant stress, which is added, in Pa and s; 0: none"},
    {"Primary creep exponent", "-", 1., 1., 100., "k"},
    {"Primary time exponent", "-", 1., 1e-3, 1., "m"},
    {"Primary hardening", "-", 0., 0., 1.,
     "what primary creep has hardened by when the stress changes: 0 the time since 0 s, 1 the "
     "primary creep strain"},
    {"Creep activation temperature", "K", 0., 0., 1e6,
     "Q/R: both coefficients vary as exp(-Q/R (1/T - 1/T0)); with Units of F in degrees of "
     "Fahrenheit, 1.8 times the figure in K"},
    {"Creep reference temperature", "degC", 20., -273., 1e4, "T0"}};

/// Creep in one increment of time: how much of it there is at a given stress.
class Creep {
public:
  /// @param temperature at the increment's end [degC], to which it has come by @p change evenly
  Creep(const double *p, const double time, const double time_increment, const double temperature,
        const double change)
      : n(p[creep_exponent]), k(p[primary_exponent]), m(p[primary_time_exponent]),
        hardens_by_strain(p[primary_hardening] >= 0.5), is_set(is_any(p)) {
    if (!is_set || time_increment <= 0.)
      return;
    const double start = std::max(0., time - time_increment);
    const auto evenly = [](const double part) { return part; };
    const Course even = course_of(p[activation], p, temperature, change, 1., evenly);
    secondary = p[creep_coefficient] * even.mean * time_increment;
    delay_of_secondary = even.centre - 0.5;
    if (p[primary_coefficient] == 0.) {
      is_on = secondary > 0.;
      return;
    }
    if (hardens_by_strain) {
      const Course course = course_of(p[activation] / m, p, temperature, change, 1., evenly);
      by_strain = std::pow(p[primary_coefficient], 1. / m) * course.mean * time_increment;
      delay_of_primary = course.centre - 0.5;
      k /= m;
    } else { // t^m goes evenly from its start to its end
      const double from = start / time_increment,
                   growth = from > 0. ? std::expm1(m * std::log1p(1. / from)) : 0.;
      const Course course =
          course_of(p[activation], p, temperature, change, m, [&](const double part) {
            return from > 0. ? std::min(1., from * std::expm1(std::log1p(part * growth) / m))
                             : std::pow(part, 1. / m);
          });
      const double whole = from > 0. ? std::pow(start, m) * growth : std::pow(time_increment, m);
      by_time = p[primary_coefficient] * course.mean * whole;
      delay_of_primary = course.centre - 0.5;
    }
    is_on = secondary > 0. || by_time > 0. || by_strain > 0.;
  }

  static bool is_any(const double *p) {
    return p[creep_coefficient] > 0. || p[primary_coefficient] > 0.;
  }
  static bool needs_primary(const double *p) {
    return p[primary_coefficient] > 0. && p[primary_hardening] >= 0.5;
  }

  /// Whether a stress that relaxes alone does so by its power: not where primary creep hardens by
  /// its strain, whose rate falls with what it has done as well.
  bool relaxes_by_power() const { return by_strain == 0.; }
  /// The same, whenever its dose comes: of one kind of creep.
  bool relaxes_by_one_power() const {
    return by_strain == 0. && (secondary == 0. || by_time == 0.);
  }

  struct Dose {
    double total, slope; ///< creep strain, its derivative by stress
    double primary;      ///< of the total
  };

  /// Creep strain that a whole increment adds under constant equivalent stress, from a primary
  /// strain of @p old_primary.
  Dose operator()(const double stress, const double old_primary) const {
    if (!(stress > 0.))
      return {0., n == 1. ? secondary : 0., 0.};
    Dose dose{};
    if (secondary > 0.) {
      dose.total = secondary * std::pow(stress, n);
      dose.slope = n * dose.total / stress;
    }
    if (by_time > 0.) {
      dose.primary = by_time * std::pow(stress, k);
      dose.slope += k * dose.primary / stress;
    } else if (by_strain > 0.) { // its m-th root grows by a
      const double a = by_strain * std::pow(stress, k), q = std::pow(old_primary, 1. / m);
      const double whole = std::pow(q + a, m);
      dose.primary = q > a ? old_primary * std::expm1(m * std::log1p(a / q)) : whole - old_primary;
      dose.slope += a > 0. ? m * whole / (q + a) * k * a / stress : 0.;
    }
    dose.total += dose.primary;
    return dose;
  }

  /// Whether doses come evenly over the increment: not where the temperature changes, or time
  /// hardens.
  bool comes_evenly() const {
    constexpr double nothing = 1e-9;
    return std::abs(delay_of_secondary) <= nothing && std::abs(delay_of_primary) <= nothing;
  }
  /// Doses per stress, each times how much of the increment it comes later than evenly: where the
  /// stress changes, the dose is off by as much as this changes.
  struct Delayed {
    double secondary, primary;
  };
  Delayed delayed(const double stress, const double old_primary) const {
    if (!(stress > 0.))
      return {0., 0.};
    const Dose dose = (*this)(stress, old_primary);
    return {delay_of_secondary * (dose.total - dose.primary) / stress,
            delay_of_primary * dose.primary / stress};
  }

private:
  /// What a dose of an increment is made of in its course.
  struct Course {
    double mean;   ///< of the Arrhenius factor exp(-Q/R (1/T - 1/T0))
    double centre; ///< part of the increment at which the dose is, in the mean
  };
  /**
   * While the temperature changes evenly, and part after part of the dose comes when @p when says,
   * from 0 to 1: creep under constant stress is exact then.
   * @param steepness of the temperature's course by parts of the dose, over even: 1/steepness
   */
  template <typename When>
  static Course course_of(const double activation_temperature, const double *p, const double end,
                          const double change, const double steepness, const When &when) {
    constexpr double zero = -273.15, panel = 2.; // of the exponent: 1e-6 of the mean
    constexpr double apart = 0.7745966692414834; // Gauss and Legendre, three points
    const double reference = 1. / (p[reference_temperature] - zero);
    const auto exponent = [&](const double temperature) {
      return activation_temperature * (reference - 1. / std::max(1., temperature - zero));
    };
    const double way = std::abs(exponent(end) - exponent(end - change));
    if (way == 0. && steepness == 1.)
      return {std::exp(exponent(end)), 0.5};
    const double n_needed = std::ceil((way / panel + (steepness < 1. ? 1. : 0.)) / steepness);
    const int n_panels = static_cast<int>(std::clamp(n_needed, 1., way == 0. ? 20. : 1000.));
    double sum = 0., moment = 0.;
    for (int i = 0; i < n_panels; ++i)
      for (const double x : {-1., 0., 1.}) {
        const double at = when((i + (1. + x * apart) / 2.) / n_panels);
        const double part =
            (x == 0. ? 8. : 5.) / 18. / n_panels * std::exp(exponent(end - change * (1. - at)));
        sum += part;
        moment += part * at;
      }
    return {way == 0. ? std::exp(exponent(end)) : sum, sum > 0. ? moment / sum : 0.5};
  }

  double n, k, m;
  bool hardens_by_strain;

public:
  bool is_set;        ///< whether there is creep at all
  bool is_on = false; ///< whether there is in this increment

private:
  double secondary = 0., by_time = 0., by_strain = 0.;
  double delay_of_secondary = 0., delay_of_primary = 0.;
};

} // namespace frictionbeam::section
