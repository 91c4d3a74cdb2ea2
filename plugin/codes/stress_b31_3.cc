// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/stress_code.h>

#include <algorithm>
#include <cmath>

/**
 * ASME B31.3, process piping: stresses of paragraphs 319.4.4, 320.2 and 302.3.6, allowable ones of
 * 302.3.5, factors of appendix D (edition 2016: a welding tee has h = 3.1 T/r2). Sustained and
 * occasional stresses are those of walls less their corrosion allowance (320.2), the expansion
 * range and all factors those of nominal walls. Mill tolerance is left to the wall's design.
 *
 * All stresses are sqrt((|Sa| + Sb)^2 + (2 St)^2). With i_i, i_o of appendix D:
 *
 *               | sustained, 320.2       | range, 319.4.4
 *   in plane    | max(1, 0.75 i_i)       | i_i
 *   out of plane| max(1, 0.75 i_o)       | i_o
 *   axial       | 1                      | 1 of pipes and bends, i_o of branch connections
 *   torsion     | 1                      | 1
 *
 * Pressure makes p d^2/(D^2 - d^2) of Sa in sustained stresses.
 */
namespace {

using namespace frictionbeam;

constexpr double pi = 3.14159265358979323846;

StressFactors factors_of_bend(const StressPoint &point) {
  const double t = point.wall, r = (point.diameter - t) / 2., R = point.bend_radius;
  const double relative =
      point.stiffening_pressure > 0. ? point.stiffening_pressure / point.youngs_modulus : 0.;
  const double k_stiffer = 1. + 6. * relative * std::pow(r / t, 7. / 3.) * std::cbrt(R / r),
               i_stiffer = 1. + 3.25 * relative * std::pow(r / t, 2.5) * std::pow(R / r, 2. / 3.);
  const double h = t * R / (r * r), root = std::pow(h, 2. / 3.);
  StressFactors factors;
  factors.flexibility = std::max(1., 1.65 / h / k_stiffer);
  factors.in_plane = std::max(1., 0.9 / root / i_stiffer);
  factors.out_of_plane = std::max(1., 0.75 / root / i_stiffer);
  return factors;
}

StressFactors factors_of_tee(const StressPoint &point) {
  const double T = point.run_wall, r = (point.run_diameter - T) / 2.;
  double h = 0.;
  bool equal = false; // in plane as out of plane
  switch (point.tee) {
  case TeeKind::welding:
  case TeeKind::welded_in:
    h = 3.1 * T / r;
    break;
  case TeeKind::reinforced: {
    const double most = 4. * T / r; // of pads above 1.5 T
    h = point.pad > 1.5 * T ? most : std::pow(T + point.pad / 2., 2.5) / (std::pow(T, 1.5) * r);
    break;
  }
  case TeeKind::unreinforced:
    h = T / r;
    break;
  case TeeKind::extruded:
    h = (1. + point.crotch_radius / r) * T / r;
    break;
  case TeeKind::integral:
    h = 3.3 * T / r;
    equal = true;
  }
  StressFactors factors;
  factors.out_of_plane = factors.axial = std::max(1., 0.9 / std::pow(h, 2. / 3.));
  factors.in_plane =
      equal ? factors.out_of_plane : std::max(1., 0.75 * factors.out_of_plane + 0.25);
  return factors;
}

enum Coefficient { per_axial, per_pressure, per_in_plane, per_out_of_plane, per_torsion };

class StressB313 final : public StressCodeBase {
public:
  const char *fault(const StressPoint &) const override { return nullptr; }

  StressFactors factors(const StressPoint &point) const override {
    switch (point.part) {
    case StressPart::bend:
      return factors_of_bend(point);
    case StressPart::run_of_tee:
    case StressPart::branch_of_tee:
      return factors_of_tee(point);
    default:
      return {};
    }
  }

  void prepare(const StressFormula formula, const StressPoint &point,
               double *const c) const override {
    const StressFactors i = factors(point);
    const bool is_range = formula == StressFormula::range;
    const double wall = point.wall - (is_range ? 0. : point.corrosion),
                 run_wall = point.run_wall - (is_range ? 0. : point.run_corrosion);
    const double D = point.diameter, d = D - 2. * wall;
    const double Z = pi / 32. * (D * D * D * D - d * d * d * d) / D, A = pi * (D - wall) * wall;
    double bending = Z;
    constexpr double same_size = 1. - 1e-6;
    if (point.part == StressPart::branch_of_tee && D < same_size * point.run_diameter) {
      // Of a reducing outlet the effective modulus pi r^2 T, 319.4.4, eq. (20).
      const double r = (D - wall) / 2.;
      bending = pi * r * r * std::min(run_wall, i.in_plane * wall);
    }
    c[per_axial] = (is_range ? i.axial : 1.) / A;
    c[per_pressure] = is_range ? 0. : d * d / (D * D - d * d);
    c[per_in_plane] = (is_range ? i.in_plane : std::max(1., 0.75 * i.in_plane)) / bending;
    c[per_out_of_plane] =
        (is_range ? i.out_of_plane : std::max(1., 0.75 * i.out_of_plane)) / bending;
    c[per_torsion] = 1. / Z; // 2 St
  }

  double stress(const StressFormula, const double *const c,
                const StressForces &forces) const override {
    const double Mi = c[per_in_plane] * forces.in_plane,
                 Mo = c[per_out_of_plane] * forces.out_of_plane,
                 normal =
                     std::abs(c[per_axial] * forces.axial + c[per_pressure] * forces.pressure) +
                     std::sqrt(Mi * Mi + Mo * Mo),
                 shear = c[per_torsion] * forces.torsion;
    return std::sqrt(normal * normal + shear * shear);
  }

  double allowed(const StressLimit limit, const StressPoint &point, const StressRules &rules,
                 const double sustained_stress) const override {
    const double Sc = point.allowable_cold, Sh = point.allowable_hot;
    switch (limit) {
    case StressLimit::sustained:
      return Sh;
    case StressLimit::occasional:
      return rules.occasional_factor * Sh;
    default: // what SL leaves of Sh may be added, 302.3.5(d)
      return rules.cycles_factor *
             (1.25 * Sc + 0.25 * Sh + (rules.liberal ? std::max(0., Sh - sustained_stress) : 0.));
    }
  }
};

constexpr StressB313 code;

} // namespace

const frictionbeam::StressCodeDescription frictionbeam_stress_code = {
    frictionbeam::stress_code_interface_version, "B31.3", "ASME B31.3-2016, appendix D", &code};
