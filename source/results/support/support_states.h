// SPDX-License-Identifier: LGPL-2.1-or-later
/// What is reported of a line's supports, each at each of its places: of one friction element, or
/// of the two of a support that stands on edges, which are one support to the user.
#pragma once

#include "model/model.h"
#include "results/results.h"

namespace frictionbeam {

/// `rests`, or `rests.3` of the third of several places.
std::string name_of_place(const std::string &part, const unsigned int place, const bool several);

/// Beside Contacts::places().
std::vector<SupportInfo> support_infos(const Model &model);
/// The support of each friction element, in support_infos().
std::vector<unsigned int> supports_of_contacts(const Contacts &contacts);

/**
 * State of a support. Of two edges, forces, works and impulses are sums, the gap is the smaller one
 * and slip the mean of what touches; the support slips if either edge does. mt has what friction
 * at the edges holds about the normal, tilt what their normal forces hold.
 */
SupportState support_state(const Model &model, const LineState &state, const unsigned int support);

/// Force on the pipe in global axes [N], of those along the axes of a support's contact.
Vector3 force_along_axes(const Contact &contact, const SupportState &state);

/// Force and moment in global axes [N, N m] of a friction element under this stress on its pipe, or
/// with @p side = 1 on what it stands on; lever arms and friction against twist included.
Motion force_of_contact(const Model &model, const unsigned int contact,
                        const Contact::Strains &stress, const unsigned int side);

/// The same of a support on its pipe, about its place.
Motion force_of_support(const Model &model, const LineState &state, const unsigned int support);

} // namespace frictionbeam
