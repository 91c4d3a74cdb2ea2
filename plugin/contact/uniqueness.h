// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "proximal_sites.h"
#include <frictionbeam/contact/condensation.h>

namespace frictionbeam::contact {

/**
 * Contacts with f >= K_tt/|K_tn|, where K = [K_nn K_tn; K_tn K_tt] is the stiffness of the line at
 * the contact, all other contacts held as they are: closed ones in their normal, sticking ones in
 * their plane, too; K_tt/|K_tn| is the least of all directions in the plane that are not held. For
 * one contact the limit is sharp (several equilibria exist above it); for many it is a warning.
 *
 * One factorization and three solutions a contact: quadratic in the number of contacts. See
 * doc/theory.md, "Exact contact", several equilibria.
 */
std::vector<BeyondUniqueness> contacts_beyond_uniqueness(const SiteList &contacts,
                                                         const Condensation &line,
                                                         const ProximalSites &proximal,
                                                         const std::vector<ContactStatus> &status);

} // namespace frictionbeam::contact
