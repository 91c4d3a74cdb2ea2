// SPDX-License-Identifier: LGPL-2.1-or-later
// The law coulomb with a fault that the conformance test shall find, chosen when compiling.
#include "../coulomb_by_another_name.h"

#include <limits>

namespace {

class FaultyCoulomb final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    double now[n_parameters];
    std::copy(in.parameters, in.parameters + n_parameters, now);
    LawInput own = in;
    own.parameters = now;
#if defined(MELTS) // a pad above 300 degC, which its closed form does not say
    now[f_static] *= in.temperature > 300. ? 0.25 : 1.;
#elif defined(WEARS_IN) // with time
    now[f_static] *= in.time > 10. ? 2. : 1.;
#endif
    const LawStatus status = law.integrate(own, out);
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
