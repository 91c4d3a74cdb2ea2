// SPDX-License-Identifier: LGPL-2.1-or-later
// The law coulomb with friction that grows with the sliding rate v, f (1 + v/(1 m/s)), with a
// closed form that says so.
#include "../coulomb_by_another_name.h"

#include <cmath>

namespace {

double growth(const LawInput &in) {
  return 1. + in.length * std::hypot(in.strain_rate[1], in.strain_rate[2]);
}

class GrowingCoulomb final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    return integrate_with_friction(growth(in), in, out);
  }
};

constexpr GrowingCoulomb growing_law;

void form(const LawInput &in, FrictionThreshold &t) {
  threshold(in, t);
  t.static_friction *= growth(in);
  t.dynamic_friction = t.static_friction;
  t.varies = true;
}

} // namespace

extern "C" __attribute__((visibility("default")))
const frictionbeam::LawDescription frictionbeam_law =
    coulomb_called("growing", &growing_law, &form);
