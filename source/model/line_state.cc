// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/line_state.h"

namespace frictionbeam {

void transfer(Archive &archive, ContactState &state) {
  archive(state.internal, state.strain, state.touch, state.dissipated, state.wear, state.impulse);
}

void transfer(Archive &archive, LineState &state) {
  archive(state.unknowns, state.dofs, state.velocity, state.acceleration, state.turns,
          state.sections, state.contacts, state.contact_stress, state.contact_status,
          state.load_factors, state.load_rates, state.load_accelerations, state.time,
          state.auxiliary, state.events);
}

} // namespace frictionbeam
