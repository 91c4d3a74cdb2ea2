// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A stress code to copy: the beam's own stress at its outer fibre, without any factor, on the wall
// that corrosion leaves. It is no code of any standard. Compile your copy with
//   find_package(FrictionBeam)  and  frictionbeam_add_stress_code(my_code my_code.cc),
// or by hand with  g++ -std=c++17 -O2 -shared -fPIC -I<include> my_code.cc -o my_code.so,
// and name it in the parameter file:
//   subsection Stress
//     set Code libraries = my_code.so
//     set Code = beam
#include <frictionbeam/stress_code.h>

#include <cmath>

namespace {

using namespace frictionbeam;

// 1. What the place decides: numbers of your own, at most n_stress_coefficients.
enum Coefficient { area, modulus, thrust };

class BeamStress final : public StressCodeBase {
public:
  // 2. What the code has no rule for. The host asks before it solves, and says where it is.
  const char *fault(const StressPoint &point) const override {
    return point.part == StressPart::run_of_tee || point.part == StressPart::branch_of_tee
               ? "a branch connection; it has rules for straight pipes and bends"
               : nullptr;
  }

  // 3. Factors: reports show them; what you do with them below is yours.
  StressFactors factors(const StressPoint &) const override { return {}; }

  // 4. Once for each place ...
  void prepare(StressFormula, const StressPoint &point, double *const c) const override {
    const double D = point.diameter, d = D - 2. * (point.wall - point.corrosion),
                 pi = 3.14159265358979323846;
    c[area] = pi / 4. * (D * D - d * d);
    c[modulus] = pi / 32. * (D * D * D * D - d * d * d * d) / D;
    c[thrust] = d * d / (D * D - d * d);
  }

  // 5. ... and the stress at each instant: convex in the forces, the same for moments of other
  // signs.
  double stress(StressFormula, const double *const c, const StressForces &forces) const override {
    const double bending = std::hypot(forces.in_plane, forces.out_of_plane) / c[modulus],
                 normal = std::abs(forces.axial / c[area] + c[thrust] * forces.pressure) + bending,
                 shear = forces.torsion / (2. * c[modulus]);
    return std::sqrt(normal * normal + 3. * shear * shear); // von Mises
  }

  // 6. What is allowed.
  double allowed(const StressLimit limit, const StressPoint &point, const StressRules &rules,
                 double) const override {
    switch (limit) {
    case StressLimit::sustained:
      return point.allowable_hot;
    case StressLimit::occasional:
      return rules.occasional_factor * point.allowable_hot;
    default:
      return rules.cycles_factor * (point.allowable_cold + point.allowable_hot);
    }
  }
};

constexpr BeamStress code;

} // namespace

// 7. What the program reads before it calls the code.
const frictionbeam::StressCodeDescription frictionbeam_stress_code = {
    frictionbeam::stress_code_interface_version,
    "beam", // the name in the parameter file
    "stresses of the beam, FrictionBeam's plugin/codes/stress_skeleton.cc", // as reports say it
    &code};
