// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"

namespace frictionbeam {

/**
 * Contacts whose forces nothing determines, although the motion is unique: some change dr
 * of the forces of rigid contacts, in the states that they have, makes no force on the line's free
 * unknowns, H^T dr = 0, as where two that stick hold one point in one direction. Forces of elastic
 * contacts follow the motion; a slipping one has the one direction (-P, T). Contacts without force
 * take no part. See doc/theory.md, "Exact contact", several equilibria.
 */
std::vector<unsigned int> contacts_with_undetermined_forces(const Contacts &contacts,
                                                            const LineState &state);

} // namespace frictionbeam
