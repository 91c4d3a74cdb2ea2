// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace frictionbeam::section {

constexpr double pi = 3.14159265358979323846;

/// One list of parameters from two.
template <std::size_t n, std::size_t m>
constexpr std::array<LawParameter, n + m> joined(const LawParameter (&first)[n],
                                                 const LawParameter (&second)[m]) {
  std::array<LawParameter, n + m> result{};
  for (std::size_t i = 0; i < n; ++i)
    result[i] = first[i];
  for (std::size_t i = 0; i < m; ++i)
    result[n + i] = second[i];
  return result;
}

/// What an accumulated strain in a state has gained since the old one of LawDescription::report.
inline double gained(const LawInput &in, const double *const state, const int place) {
  return state[place] - (in.old_state == nullptr ? 0. : in.old_state[place]);
}

constexpr int n_curve_points = 6, n_temperatures = 4;

/// Places of the material's parameters within their own list.
enum MaterialParameter {
  yield_stress,
  isotropic_modulus,
  kinematic_modulus,
  curve,                                     ///< pairs of plastic strain and stress
  temperatures = curve + 2 * n_curve_points, ///< triples of temperature and two factors
  n_material_parameters = temperatures + 3 * n_temperatures
};

constexpr LawParameter material_parameters[n_material_parameters] = {
    {"Yield stress", "Pa", 2e8, 1e-300, 1e300, "at which plastic flow begins"},
    {"Isotropic modulus", "Pa", 0., 0., 1e300,
     "slope of the yield stress over the accumulated plastic strain, on top of the points below"},
    {"Kinematic modulus", "Pa", 0., 0., 1e300,
     "H, slope of the back stress over the plastic strain in tension"},
    {"Hardening strain 1", "-", 0., 0., 1e300, "plastic strain at which stress 1 is reached"},
    {"Hardening stress 1", "Pa", 0., 0., 1e300, "yield stress there; 0: not used"},
    {"Hardening strain 2", "-", 0., 0., 1e300, "above strain 1"},
    {"Hardening stress 2", "Pa", 0., 0., 1e300, "not below stress 1; 0: not used"},
    {"Hardening strain 3", "-", 0., 0., 1e300, "above strain 2"},
    {"Hardening stress 3", "Pa", 0., 0., 1e300, "not below stress 2; 0: not used"},
    {"Hardening strain 4", "-", 0., 0., 1e300, "above strain 3"},
    {"Hardening stress 4", "Pa", 0., 0., 1e300, "not below stress 3; 0: not used"},
    {"Hardening strain 5", "-", 0., 0., 1e300, "above strain 4"},
    {"Hardening stress 5", "Pa", 0., 0., 1e300, "not below stress 4; 0: not used"},
    {"Hardening strain 6", "-", 0., 0., 1e300, "above strain 5"},
    {"Hardening stress 6", "Pa", 0., 0., 1e300, "not below stress 5; 0: not used"},
    {"Temperature 1", "degC", 20., -273.15, 1e4, "of factors 1"},
    {"Modulus factor 1", "-", 0., 0., 1e3, "of all moduli of elasticity there; 0: not used"},
    {"Yield factor 1", "-", 1., 1e-6, 1e3, "of the yield stress and its curve there"},
    {"Temperature 2", "degC", 20., -273.15, 1e4, "of factors 2, above temperature 1"},
    {"Modulus factor 2", "-", 0., 0., 1e3, "0: not used"},
    {"Yield factor 2", "-", 1., 1e-6, 1e3, "see factor 1"},
    {"Temperature 3", "degC", 20., -273.15, 1e4, "of factors 3, above temperature 2"},
    {"Modulus factor 3", "-", 0., 0., 1e3, "0: not used"},
    {"Yield factor 3", "-", 1., 1e-6, 1e3, "see factor 1"},
    {"Temperature 4", "degC", 20., -273.15, 1e4, "of factors 4, above temperature 3"},
    {"Modulus factor 4", "-", 0., 0., 1e3, "0: not used"},
    {"Yield factor 4", "-", 1., 1e-6, 1e3, "see factor 1"}};

/**
 * What a metal is like at a temperature: the factor of its moduli, its kinematic modulus H, and its
 * yield stress
 *   R(p) = f_y (curve(p) + h p),
 * p the accumulated plastic strain, the curve through (0, yield stress) and up to six points,
 * straight between them and level behind the last; f_y and the factor of the moduli straight
 * between the temperatures that are given, level outside.
 */
class Material {
public:
  Material(const double *p, const double temperature) : H(p[kinematic_modulus]) {
    double yield_factor = 1.;
    set_factors(p + temperatures, temperature, yield_factor);
    stress[0] = p[yield_stress];
    for (const double *point = p + curve; n_points <= n_curve_points && point[1] > 0.;
         point += 2, ++n_points) {
      strain[n_points] = point[0];
      stress[n_points] = point[1];
      is_possible =
          is_possible && point[0] > strain[n_points - 1] && point[1] >= stress[n_points - 1];
    }
    for (int i = 0; i < n_points; ++i) {
      stress[i] = yield_factor * (stress[i] + p[isotropic_modulus] * strain[i]);
      if (i > 0) {
        slopes[i - 1] = (stress[i] - stress[i - 1]) / (strain[i] - strain[i - 1]);
        energy[i] = energy[i - 1] +
                    (strain[i] - strain[i - 1]) * ((stress[i] + stress[i - 1]) / 2. - stress[0]);
      }
    }
    slopes[n_points - 1] = yield_factor * p[isotropic_modulus];
  }

  double H;                   ///< [Pa]
  double modulus_factor = 1.; ///< of Young's modulus and all that goes with it
  bool is_possible = true;    ///< whether the curve rises from point to point

  bool is_perfect() const { return H == 0. && n_points == 1 && slopes[0] == 0.; }
  bool hardens_isotropically() const { return n_points > 1 || slopes[0] > 0.; }
  /// Stress that is never reached, if there is no hardening to speak of; else infinity.
  double largest(const double least_slope) const {
    return std::max(H, slopes[n_points - 1]) > least_slope ? std::numeric_limits<double>::infinity()
                                                           : stress[n_points - 1];
  }
  /// See to it that the metal hardens by this slope at least.
  void raise_level_end(const double least_slope) {
    if (H < least_slope)
      slopes[n_points - 1] = std::max(slopes[n_points - 1], least_slope);
  }

  double first_yield() const { return stress[0]; }
  double slope(const double p) const { return slopes[piece(p)]; }
  double yield(const double p) const {
    const int i = piece(p);
    return stress[i] + slopes[i] * (p - strain[i]);
  }
  /// Integral of R - R(0) from 0 to p [J/m3]: what isotropic hardening stores.
  double stored(const double p) const {
    const int i = piece(p);
    const double dp = p - strain[i];
    return energy[i] + dp * (stress[i] - stress[0] + slopes[i] * dp / 2.);
  }

private:
  int piece(const double p) const {
    int i = n_points - 1;
    while (i > 0 && p < strain[i])
      --i;
    return i;
  }

  void set_factors(const double *table, const double temperature, double &yield_factor) {
    const double *last = nullptr;
    for (int i = 0; i < n_temperatures && table[3 * i + 1] > 0.; ++i) {
      const double *const row = table + 3 * i;
      is_possible = is_possible && (last == nullptr || row[0] > last[0]);
      const bool begins = last == nullptr || temperature >= row[0];
      const double share = begins                   ? 1.
                           : temperature >= last[0] ? (temperature - last[0]) / (row[0] - last[0])
                                                    : 0.;
      if (share == 1.) {
        modulus_factor = row[1];
        yield_factor = row[2];
      } else if (share > 0.) {
        modulus_factor = last[1] + share * (row[1] - last[1]);
        yield_factor = last[2] + share * (row[2] - last[2]);
      }
      last = row;
    }
  }

  int n_points = 1;
  double strain[n_curve_points + 1] = {}, stress[n_curve_points + 1] = {},
                                 slopes[n_curve_points + 1] = {}, energy[n_curve_points + 1] = {};
};

/// What is wrong with a material, if anything (LawDescription::fault).
inline const char *fault_of_material(const double *material) {
  const double *const point = material + curve, *const row = material + temperatures;
  for (int i = 0; i < n_curve_points; ++i) {
    const bool is_behind = i > 0 && !(point[2 * i - 1] > 0.);
    if ((point[2 * i + 1] > 0. && is_behind) || (point[2 * i] > 0. && !(point[2 * i + 1] > 0.)))
      return "points of the curve one after the other, each with its stress: 'Hardening strain' "
             "and "
             "'Hardening stress' from 1 on, none left out";
  }
  for (int i = 0; i < n_temperatures; ++i) {
    const bool is_used = row[3 * i + 1] > 0., is_behind = i > 0 && !(row[3 * i - 2] > 0.);
    if ((is_used && is_behind) || (!is_used && row[3 * i + 2] != 1.))
      return "temperatures one after the other, each with the factor of its modulus: 'Modulus "
             "factor' "
             "and 'Yield factor' from 1 on, none left out";
  }
  if (!Material(material, 20.).is_possible)
    return "strains that rise from point to point of the curve, with stresses that do not fall and "
           "temperatures that rise: put 'Hardening strain', 'Hardening stress' and 'Temperature' "
           "in order, from 1 on";
  return nullptr;
}

/// The same of a pipe with its wall.
inline const char *fault_of(const double *material, const double diameter, const double wall) {
  if (!(diameter > 2. * wall))
    return "a wall below half the diameter: make 'Wall thickness' smaller";
  return fault_of_material(material);
}

} // namespace frictionbeam::section
