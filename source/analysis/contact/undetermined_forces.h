// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"

namespace frictionbeam {

/**
 * Contacts whose forces nothing determines. In the states that they have, rigid contacts may change
 * their forces by A dr and let no motion happen with B^T du != 0: a sticking one in each direction
 * that it holds; of a slipping one A has the direction (-P, T) and B the normal. Elastic ones
 * follow the motion, those without force take no part. [K -A; B^T 0] is singular, whatever the
 * line's K, where A dr = 0 on the line's free unknowns: two that stick hold one point in one
 * direction, and the motion is unique; where the columns of B depend on each other: a rest slides
 * along at a point that a line stop's friction carries, and its share says how far. Friction at its
 * limit counts as sticking in its direction where others hold the point still. See
 * doc/theory.md, "Exact contact", several equilibria.
 */
std::vector<unsigned int> contacts_with_undetermined_forces(const Contacts &contacts,
                                                            const LineState &state);

/// Whether contacts have unknowns in common, without which none has undetermined forces.
bool share_unknowns(const Contacts &contacts);

} // namespace frictionbeam
