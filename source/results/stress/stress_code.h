// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"
#include <frictionbeam/stress_code_library.h>

#include <array>

namespace frictionbeam {

/**
 * A loaded stress code (frictionbeam/stress_code.h) with the user's rules. What it throws, and
 * numbers that none can be, become a UserError that names the code.
 */
class StressCode {
public:
  /// @param settings that name the code and hold its library
  explicit StressCode(const StressSettings &settings);

  const std::string &name() const { return edition; } ///< with its edition

  /// What is wrong with the code at a place, or with the place for the code; empty: nothing.
  std::string fault(const StressPoint &point) const;

  StressFactors intensification(const StressPoint &point) const;

  /// A stress at one place by the forces there [Pa], with all that the place decides worked out: to
  /// be evaluated at every instant of a motion. Convex in the forces.
  class Formula {
  public:
    double operator()(const StressForces &forces) const;

  private:
    friend class StressCode;
    Formula(const StressCodeDescription &code, const StressFormula formula)
        : code(&code), formula(formula) {}

    const StressCodeDescription *code;
    StressFormula formula;
    std::array<double, n_stress_coefficients> coefficients{};
  };
  /// Longitudinal stress of weight, pressure and what else is sustained or occasional.
  Formula sustained(const StressPoint &point) const {
    return prepared(StressFormula::longitudinal, point);
  }
  /// Of the difference of the forces of two states.
  Formula expansion_range(const StressPoint &point) const {
    return prepared(StressFormula::range, point);
  }

  /// What is allowed [Pa], > 0. @param sustained_stress SL there, for a range
  double allowed(const StressLimit limit, const StressPoint &point,
                 const double sustained_stress = 0.) const;

private:
  Formula prepared(const StressFormula formula, const StressPoint &point) const;

  const StressCodeDescription &code;
  std::string edition;
  StressRules rules;
};

} // namespace frictionbeam
