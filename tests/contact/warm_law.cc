// SPDX-License-Identifier: LGPL-2.1-or-later
// The law coulomb with friction that falls with temperature, f (1 - 0.002 (T - 20 degC)), without a
// closed form, or WITH_FORM with one that says so.
#include "../coulomb_by_another_name.h"

namespace {

double softness(const LawInput &in) { return 1. - 0.002 * (in.temperature - 20.); }

class WarmCoulomb final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    return integrate_with_friction(softness(in), in, out);
  }
};

constexpr WarmCoulomb warm_law;

#ifdef WITH_FORM
void form(const LawInput &in, FrictionThreshold &t) {
  threshold(in, t);
  t.static_friction *= softness(in);
  t.dynamic_friction = t.static_friction;
  t.varies = true;
}
#define FORM &form
#else
#define FORM nullptr
#endif

} // namespace

extern "C" __attribute__((visibility("default")))
const frictionbeam::LawDescription frictionbeam_law = coulomb_called("warm", &warm_law, FORM);
