// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/user_error.h"
#include "results/stress/stress_code.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

BendFactors b31_3_bend(const double diameter, const double wall, const double bend_radius,
                       const double youngs_modulus, const double pressure) {
  const double t = wall, r = (diameter - wall) / 2., R = bend_radius;
  const double relative = pressure / youngs_modulus;
  const double k_stiffer = 1. + 6. * relative * std::pow(r / t, 7. / 3.) * std::cbrt(R / r),
               i_stiffer = 1. + 3.25 * relative * std::pow(r / t, 2.5) * std::pow(R / r, 2. / 3.);
  BendFactors factors;
  factors.h = t * R / (r * r);
  const double root = std::pow(factors.h, 2. / 3.);
  factors.k = std::max(1., 1.65 / factors.h / k_stiffer);
  factors.in_plane = std::max(1., 0.9 / root / i_stiffer);
  factors.out_of_plane = std::max(1., 0.75 / root / i_stiffer);
  return factors;
}

namespace numbers = dealii::numbers;

namespace {

/**
 * ASME B31.3, process piping: stresses of paragraphs 319.4.4, 320.2 and 302.3.6, allowable ones of
 * 302.3.5, factors of appendix D (edition 2016: a welding tee has h = 3.1 T/r2). Sustained and
 * occasional stresses are those of the wall less its corrosion allowance (320.2), the expansion
 * range and all factors those of the nominal wall. Mill tolerance is left to the wall's design.
 */
class StressB313 final : public StressCode {
public:
  std::string name() const override { return "ASME B31.3-2016, appendix D"; }

  Factors intensification(const StressPoint &point) const override {
    using Part = StressPoint::Part;
    if (point.part == Part::straight)
      return {};
    if (point.part == Part::bend) {
      const BendFactors bend = b31_3_bend(point.diameter, point.wall, point.bend_radius,
                                          point.youngs_modulus, point.stiffening_pressure);
      return {bend.in_plane, bend.out_of_plane};
    }
    const double T = point.run_wall, r = (point.run_diameter - T) / 2.;
    double h = 0.;
    bool equal = false; // in-plane as out-of-plane
    switch (point.tee) {
    case Tee::Kind::welding:
    case Tee::Kind::welded_in:
      h = 3.1 * T / r;
      break;
    case Tee::Kind::reinforced: {
      const double pad = std::min(point.pad, 1.5 * T);
      h = std::pow(T + pad / 2., 2.5) / (std::pow(T, 1.5) * r);
      break;
    }
    case Tee::Kind::unreinforced:
      h = T / r;
      break;
    case Tee::Kind::extruded:
      h = (1. + point.crotch_radius / r) * T / r;
      break;
    case Tee::Kind::integral:
      h = 3.3 * T / r;
      equal = true;
    }
    const double out_of_plane = std::max(1., 0.9 / std::pow(h, 2. / 3.));
    return {equal ? out_of_plane : std::max(1., 0.75 * out_of_plane + 0.25), out_of_plane};
  }

  Formula sustained(const StressPoint &point) const override {
    // Indices: 0.75 i but not below 1 for bending, 1 for axial force and torsion (320.2).
    const Factors i = intensification(point);
    StressPoint corroded = point;
    corroded.wall -= point.corrosion;
    const double D = point.diameter, d = D - 2. * corroded.wall;
    return combination(corroded, std::max(1., 0.75 * i.in_plane),
                       std::max(1., 0.75 * i.out_of_plane), i.in_plane, d * d / (D * D - d * d));
  }

  Formula expansion_range(const StressPoint &point) const override {
    const Factors i = intensification(point);
    return combination(point, i.in_plane, i.out_of_plane, i.in_plane, 0.);
  }

  double allowed_sustained(const StressPoint &point) const override { return point.allowable_hot; }
  double allowed_occasional(const StressPoint &point,
                            const StressSettings &settings) const override {
    return settings.occasional_factor * point.allowable_hot;
  }
  double allowed_range(const StressPoint &point, const StressSettings &settings,
                       const double sustained_stress) const override {
    const double Sc = point.allowable_cold, Sh = point.allowable_hot;
    if (settings.liberal)
      return settings.cycles_factor * (1.25 * (Sc + Sh) - sustained_stress);
    return settings.cycles_factor * (1.25 * Sc + 0.25 * Sh);
  }

private:
  static double area(const StressPoint &point) {
    return numbers::PI * (point.diameter - point.wall) * point.wall;
  }

  static double modulus(const StressPoint &point) {
    const double D = point.diameter, d = D - 2. * point.wall;
    return numbers::PI / 32. * (D * D * D * D - d * d * d * d) / D;
  }

  /// sqrt((|Sa| + Sb)^2 + (2 St)^2); a branch's bending has the effective modulus pi r^2 T.
  /// @param in_plane, out_of_plane indices @param i_in that makes the effective modulus
  /// @param thrust axial stress per pressure
  static Formula combination(const StressPoint &point, const double in_plane,
                             const double out_of_plane, const double i_in, const double thrust) {
    const double Z = modulus(point), A = area(point);
    double bending = Z;
    if (point.part == StressPoint::Part::branch_of_tee) {
      const double r = (point.diameter - point.wall) / 2.;
      bending = numbers::PI * r * r * std::min(point.run_wall, i_in * point.wall);
    }
    return [=](const StressForces &forces) {
      const double Mi = in_plane * forces.in_plane, Mo = out_of_plane * forces.out_of_plane,
                   Sb = std::sqrt(Mi * Mi + Mo * Mo) / bending,
                   normal = std::abs(forces.axial / A + thrust * forces.pressure) + Sb,
                   shear = forces.torsion / Z; // 2 St
      return std::sqrt(normal * normal + shear * shear);
    };
  }
};

} // namespace

std::unique_ptr<const StressCode> make_stress_code(const std::string &name) {
  if (name == "B31.3")
    return std::make_unique<StressB313>();
  throw UserError("There is no stress code '" + name + "'. Allowed: B31.3.");
}

} // namespace frictionbeam
