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
     "Q/R: both coefficients vary as exp(-Q/R (1/T - 1/T0))"},
    {"Creep reference temperature", "degC", 20., -273., 1e4, "T0"}};

/// Creep in one increment of time: how much of it there is at a given stress.
class Creep {
public:
  Creep(const double *p, const double time, const double time_increment, const double temperature)
      : n(p[creep_exponent]), k(p[primary_exponent]), m(p[primary_time_exponent]),
        hardens_by_strain(p[primary_hardening] >= 0.5), is_set(is_any(p)) {
    if (!is_set || time_increment <= 0.)
      return;
    const double zero = -273.15;
    const double factor = std::exp(-p[activation] * (1. / std::max(1., temperature - zero) -
                                                     1. / (p[reference_temperature] - zero)));
    const double start = std::max(0., time - time_increment);
    secondary = p[creep_coefficient] * factor * time_increment;
    if (hardens_by_strain) {
      by_strain = std::pow(p[primary_coefficient] * factor, 1. / m) * time_increment;
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
  double n, k, m;
  bool hardens_by_strain;

public:
  bool is_set;        ///< whether there is creep at all
  bool is_on = false; ///< whether there is in this increment

private:
  double secondary = 0., by_time = 0., by_strain = 0.;
};

} // namespace frictionbeam::section
