// SPDX-License-Identifier: LGPL-2.1-or-later
// A stress code with one fault, by the macro that it is compiled with (CMakeLists.txt): without it,
// a stress of bending and axial force that passes all checks.
#include <frictionbeam/stress_code.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

using namespace frictionbeam;

class Broken final : public StressCodeBase {
public:
  const char *fault(const StressPoint &) const override {
#ifdef NO_RULE
    return "a straight pipe, of which it has no rule";
#else
    return nullptr;
#endif
  }

  StressFactors factors(const StressPoint &) const override {
#ifdef THROWS_IN_FACTORS
    throw std::runtime_error("no factors");
#endif
    StressFactors result;
#ifdef FACTOR_INFINITE
    result.in_plane = std::numeric_limits<double>::infinity();
#endif
    return result;
  }

  void prepare(StressFormula, const StressPoint &point, double *const c) const override {
#ifdef THROWS
    throw std::runtime_error("no such place");
#endif
    c[0] = point.diameter;
    c[1] = point.wall;
  }

  double stress(StressFormula, const double *const c, const StressForces &f) const override {
    const double bending = std::hypot(f.in_plane, f.out_of_plane) / (c[0] * c[0] * c[1]),
                 normal = std::abs(f.axial) / (c[0] * c[1]);
#ifdef NOT_A_NUMBER
    return 0. * std::numeric_limits<double>::infinity() + normal + bending;
#elif defined(NEGATIVE)
    return bending - normal - 1.;
#elif defined(NOT_CONVEX)
    return std::sqrt(bending + normal);
#elif defined(SIGN_OF_MOMENT)
    return normal + bending + std::max(0., f.in_plane) / (c[0] * c[0] * c[1]);
#elif defined(SIGN_OF_ONE_MOMENT) // the same where both turn
    return normal + std::hypot(f.in_plane + f.torsion, f.out_of_plane) / (c[0] * c[0] * c[1]);
#elif defined(SIGN_OUT_OF_PLANE)
    return normal + bending + std::max(0., f.out_of_plane) / (c[0] * c[0] * c[1]);
#elif defined(NAN_IN_THE_RUN)
    return std::abs(f.out_of_plane - 2000.) < 1e-3 ? std::numeric_limits<double>::quiet_NaN()
                                                   : normal + bending;
#elif defined(THROWS_IN_THE_RUN)
    if (std::abs(f.out_of_plane - 2000.) < 1e-3)
      throw std::out_of_range("beyond the table");
    return normal + bending;
#else
    return normal + bending;
#endif
  }

  double allowed(StressLimit, const StressPoint &point, const StressRules &,
                 double) const override {
#ifdef NOTHING_ALLOWED
    return 0. * point.allowable_hot;
#else
    return point.allowable_hot;
#endif
  }
};

constexpr Broken code;

} // namespace

#ifndef SYMBOL_MISSING
const frictionbeam::StressCodeDescription frictionbeam_stress_code = {
#ifdef VERSION_WRONG
    frictionbeam::stress_code_interface_version + 1,
#else
    frictionbeam::stress_code_interface_version,
#endif
#ifdef NAME_MISSING
    "",
#elif defined(NAME_TAKEN)
    "B31.3",
#elif defined(NAME_OTHER)
    "other",
#else
    "beam",
#endif
#ifdef EDITION_MISSING
    nullptr,
#else
    "none",
#endif
#ifdef CODE_MISSING
    nullptr
#else
    &code
#endif
};
#else
const frictionbeam::StressCodeBase *answer() { return &code; }
#endif
