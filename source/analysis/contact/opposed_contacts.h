// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/contact/contacts.h"
#include "model/line_state.h"

#include <functional>

namespace frictionbeam {

/**
 * Contacts that touch without force while another one at the same node touches from the other side:
 * the idle half of a stop or guide that holds both ways. To either side only one of the two
 * resists, so what is linear about a state with both closed counts one of them; of two without
 * force, the later one is idle.
 */
std::vector<bool> idle_halves(const Contacts &contacts, const LineState &state);
/// The same of contacts by their places in the list. @param force along the normal [N], >= 0
std::vector<bool> idle_halves(const Contacts &contacts,
                              const std::function<bool(unsigned int)> &touches,
                              const std::function<double(unsigned int)> &force);

/**
 * Of a pose whose stability is asked for, those that do not hold it: idle halves, and contacts that
 * carry at most @p nothing [N] with none at their node that touches from the other side. The line
 * leaves them without resistance to one side, and a mode of buckling has two; that other nodes may
 * bar either is not seen. A law without closed form may pull as well as push, and holds.
 */
std::vector<bool> contacts_that_do_not_hold(const Contacts &contacts,
                                            const std::function<bool(unsigned int)> &touches,
                                            const std::function<double(unsigned int)> &force,
                                            const double nothing);
std::vector<bool> contacts_that_do_not_hold(const Contacts &contacts, const LineState &state,
                                            const double nothing);

/// Whether another contact at the node of contact @p i touches from the other side.
bool is_held_opposite(const Contacts &contacts, const LineState &state, const unsigned int i);

} // namespace frictionbeam
