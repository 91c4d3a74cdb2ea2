// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/stress/stress_code.h"

#include "base/user_error.h"

#include <cmath>

namespace frictionbeam {

namespace {

[[noreturn]] void fail(const StressCodeDescription &code, const std::string &read,
                       const std::string &expected) {
  throw UserError("The stress code '" + std::string(code.name) +
                  "' gives no answer.\n  read:    " + read + "\n  allowed: " + expected +
                  "\n  try:     to mend the code (doc/stress_codes.md), or another one");
}

/// What a function of a code returns; what it throws is told to the user.
template <typename Call>
auto ask(const StressCodeDescription &code, const Call &call) {
  try {
    return call();
  } catch (const std::exception &error) {
    fail(code, std::string("an exception: ") + error.what(),
         "a number, or a word in fault() that there is none");
  }
}

const StressCodeDescription &code_of(const StressSettings &settings) {
  const StressCodeDescription *const code =
      settings.codes ? settings.codes->find(settings.code) : nullptr;
  AssertThrow(code != nullptr, dealii::ExcInternalError());
  return *code;
}

} // namespace

StressCode::StressCode(const StressSettings &settings)
    : code(code_of(settings)),
      edition(code.edition), rules{settings.cycles_factor, settings.liberal,
                                   settings.occasional_factor} {}

std::string StressCode::fault(const StressPoint &point) const {
  try {
    if (const char *const word = code.code->fault(point))
      return word;
    const auto faults = stress_code_faults(code, point, rules);
    return faults.empty() ? "" : "what no stress code does: " + faults.front();
  } catch (const std::exception &error) {
    return std::string("an exception: ") + error.what();
  }
}

StressFactors StressCode::intensification(const StressPoint &point) const {
  return ask(code, [&] { return code.code->factors(point); });
}

StressCode::Formula StressCode::prepared(const StressFormula formula,
                                         const StressPoint &point) const {
  Formula result(code, formula);
  ask(code, [&] { code.code->prepare(formula, point, result.coefficients.data()); });
  return result;
}

double StressCode::Formula::operator()(const StressForces &forces) const {
  const double stress =
      ask(*code, [&] { return code->code->stress(formula, coefficients.data(), forces); });
  if (!(stress >= 0.) || !std::isfinite(stress))
    fail(*code,
         "a stress of " + std::to_string(stress) + " Pa by an axial force of " +
             std::to_string(forces.axial) + " N and moments of " + std::to_string(forces.in_plane) +
             ", " + std::to_string(forces.out_of_plane) + " and " + std::to_string(forces.torsion) +
             " N m",
         "numbers >= 0 [Pa]");
  return stress;
}

double StressCode::allowed(const StressLimit limit, const StressPoint &point,
                           const double sustained_stress) const {
  const double result =
      ask(code, [&] { return code.code->allowed(limit, point, rules, sustained_stress); });
  if (!(result > 0.) || !std::isfinite(result))
    fail(code, "an allowable stress of " + std::to_string(result) + " Pa", "numbers > 0 [Pa]");
  return result;
}

} // namespace frictionbeam
