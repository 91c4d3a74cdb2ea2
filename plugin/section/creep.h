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
    const double factor = mean_factor(p[activation], p, temperature, change);
    const double start = std::max(0., time - time_increment);
    secondary = p[creep_coefficient] * factor * time_increment;
    if (hardens_by_strain) {
      by_strain = std::pow(p[primary_coefficient], 1. / m) *
                  mean_factor(p[activation] / m, p, temperature, change) * time_increment;
      k /= m;
    } else
      by_time = p[primary_coefficient] * factor *
                (std::pow(start + time_increment, m) - std::pow(start, m));
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

private:
  /// Mean of exp(-Q/R (1/T - 1/T0)) over the increment: what creeps is then exact where nothing
  /// else changes, and of second order with what does.
  static double mean_factor(const double activation_temperature, const double *p, const double end,
                            const double change) {
    constexpr double zero = -273.15, panel = 2.; // of the exponent: 1e-6 of the mean
    const double reference = 1. / (p[reference_temperature] - zero);
    const auto exponent = [&](const double temperature) {
      return activation_temperature * (reference - 1. / std::max(1., temperature - zero));
    };
    const double way = std::abs(exponent(end) - exponent(end - change));
    if (way == 0.)
      return std::exp(exponent(end));
    constexpr double apart = 0.7745966692414834; // Gauss and Legendre, three points
    const int n_panels = static_cast<int>(std::min(1000., std::ceil(way / panel)));
    double sum = 0.;
    for (int i = 0; i < n_panels; ++i)
      for (const double x : {-1., 0., 1.})
        sum += (x == 0. ? 8. : 5.) / 18. *
               std::exp(exponent(end - change * (i + (1. + x * apart) / 2.) / n_panels));
    return sum / n_panels;
  }

  double n, k, m;
  bool hardens_by_strain;

public:
  bool is_set;        ///< whether there is creep at all
  bool is_on = false; ///< whether there is in this increment

private:
  double secondary = 0., by_time = 0., by_strain = 0.;
};

} // namespace frictionbeam::section
