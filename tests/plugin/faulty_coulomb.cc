// SPDX-License-Identifier: LGPL-2.1-or-later
// The law coulomb with a fault that the conformance test shall find, chosen when compiling.
#include "../coulomb_by_another_name.h"

#include <limits>

namespace {

class FaultyCoulomb final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    double factor = 1.;
#if defined(MELTS) // a pad above 300 degC, which its closed form does not say
    factor = in.temperature > 300. ? 0.25 : 1.;
#elif defined(WEARS_IN) // with time
    factor = in.time > 10. ? 2. : 1.;
#endif
    const LawStatus status = integrate_with_friction(factor, in, out);
#if defined(DIVIDES_BY_TIME)
    if (in.time_increment == 0.)
      out.stress[1] = std::numeric_limits<double>::quiet_NaN();
#elif defined(TWISTS_ON)
    out.stress[3] *= -1.;
    if (in.tangent != LawTangent::none)
      for (int j = 0; j < n_support_strains; ++j)
        out.tangent[3 * n_support_strains + j] *= -1.;
#endif
    return status;
  }
};

constexpr FaultyCoulomb faulty_law;

#if defined(MELTS) || defined(WEARS_IN)
#define FORM &threshold
#else
#define FORM nullptr
[[maybe_unused]] const auto unused = &threshold;
#endif

} // namespace

extern "C" __attribute__((visibility("default")))
const frictionbeam::LawDescription frictionbeam_law = coulomb_called("faulty", &faulty_law, FORM);
