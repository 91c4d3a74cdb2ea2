// SPDX-License-Identifier: LGPL-2.1-or-later
// The law coulomb under another name and with a closed form that is not its own: by LIAR five times
// the friction, by WILD a place in the state that does not exist.
#include "../../coulomb_by_another_name.h"

namespace {

void other_threshold(const LawInput &in, FrictionThreshold &t) {
  threshold(in, t);
#ifdef LIAR
  t.static_friction *= 5.;
  t.dynamic_friction *= 5.;
#else
  t.slip_y = 77;
#endif
}

} // namespace

extern "C" __attribute__((visibility("default")))
const frictionbeam::LawDescription frictionbeam_law =
    coulomb_called("other", &law, &other_threshold);
