// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/stress_code_library.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace frictionbeam {

namespace {

constexpr double rounding = 1e-9;

/// One code at one place.
class PlaceCheck {
public:
  PlaceCheck(const StressCodeDescription &description, const StressPoint &point)
      : code(*description.code), point(point) {}

  std::vector<std::string> faults;

  void check_numbers(const StressRules &rules) {
    const StressFactors i = code.factors(point);
    for (const auto &[factor, what] :
         {std::pair<double, const char *>{i.flexibility, "flexibility"},
          {i.in_plane, "in plane"},
          {i.out_of_plane, "out of plane"},
          {i.axial, "axial"}})
      require(factor > 0. && std::isfinite(factor), std::string("a factor > 0, ") + what, factor);
    for (const auto &[limit, what] :
         {std::pair<StressLimit, const char *>{StressLimit::sustained, "sustained"},
          {StressLimit::occasional, "occasional"},
          {StressLimit::range, "range"}}) {
      const double allowed = code.allowed(limit, point, rules, 0.);
      require(allowed > 0. && std::isfinite(allowed),
              std::string("an allowable stress > 0 [Pa], ") + what, allowed);
    }
  }

  void check_formula(const StressFormula formula, const char *const what) {
    std::array<double, n_stress_coefficients> coefficients{};
    code.prepare(formula, point, coefficients.data());
    const auto stress = [&](const StressForces &forces) {
      return code.stress(formula, coefficients.data(), forces);
    };
    const std::vector<StressForces> tries = forces_to_try(formula);
    std::vector<double> values;
    for (const StressForces &forces : tries) {
      values.push_back(stress(forces));
      require(values.back() >= 0. && std::isfinite(values.back()),
              std::string("a stress >= 0 [Pa], ") + what, values.back());
      // Each alone: what is wrong with two moments may be right where both turn.
      for (const auto &[moment, name] : {std::pair(&StressForces::in_plane, "in plane"),
                                         {&StressForces::out_of_plane, "out of plane"},
                                         {&StressForces::torsion, "torsion"}}) {
        StressForces turned = forces;
        turned.*moment = -(forces.*moment);
        const double other = stress(turned);
        require(std::abs(other - values.back()) <= rounding * (std::abs(other) + values.back()),
                std::string("the same stress for moments of other signs, ") + what + ", " + name,
                other);
      }
      if (!faults.empty())
        return;
    }
    for (std::size_t a = 0; a < tries.size(); ++a)
      for (std::size_t b = 0; b < a && faults.empty(); ++b) {
        const double between = stress(middle(tries[a], tries[b])),
                     mean = 0.5 * (values[a] + values[b]);
        require(between <= mean + rounding * (mean + between),
                std::string("between two states no more than their mean (convex), ") + what,
                between / mean);
      }
  }

private:
  void require(const bool condition, const std::string &expected, const double read) {
    std::ostringstream text;
    text << "read " << read << ", expected " << expected;
    if (!condition)
      faults.push_back(text.str());
  }

  static StressForces middle(const StressForces &a, const StressForces &b) {
    return {0.5 * (a.axial + b.axial), 0.5 * (a.in_plane + b.in_plane),
            0.5 * (a.out_of_plane + b.out_of_plane), 0.5 * (a.torsion + b.torsion), a.pressure};
  }

  /// Forces that make about the allowable stress in a straight pipe, and parts of them.
  std::vector<StressForces> forces_to_try(const StressFormula formula) const {
    const double D = point.diameter, t = point.wall, S = point.allowable_cold,
                 area = 3.14 * (D - t) * t, modulus = area * D / 4.,
                 pressure = formula == StressFormula::range ? 0. : 2. * S * t / D;
    std::vector<StressForces> tries;
    for (const double axial : {-1., 0., 0.4})
      for (const double in_plane : {0., 0.3, -1.})
        for (const double out_of_plane : {0., 0.8})
          for (const double torsion : {0., 0.5})
            tries.push_back({axial * S * area, in_plane * S * modulus, out_of_plane * S * modulus,
                             torsion * S * modulus, pressure});
    return tries;
  }

  const StressCodeBase &code;
  const StressPoint &point;
};

} // namespace

std::vector<std::string> stress_code_faults(const StressCodeDescription &code,
                                            const StressPoint &point, const StressRules &rules) {
  PlaceCheck check(code, point);
  check.check_numbers(rules);
  if (check.faults.empty())
    check.check_formula(StressFormula::longitudinal, "sustained or occasional");
  if (check.faults.empty())
    check.check_formula(StressFormula::range, "range");
  return check.faults;
}

} // namespace frictionbeam
