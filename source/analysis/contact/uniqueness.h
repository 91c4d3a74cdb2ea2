// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/condensed_line.h"
#include "analysis/contact/proximal_contacts.h"

namespace frictionbeam {

/// A contact whose friction exceeds the limit up to which its state is unique.
struct BeyondUniqueness {
  unsigned int contact;
  double friction, limit;
};

/**
 * Contacts with f >= K_tt/|K_tn|, where K = [K_nn K_tn; K_tn K_tt] is the stiffness of the line at
 * the contact, all other contacts held as they are: closed ones in their normal, sticking ones in
 * their plane, too; K_tt/|K_tn| is the least of all directions in the plane that are not held. For
 * one contact the limit is sharp (several equilibria exist above it); for many it is a warning.
 *
 * One factorization and three solutions a contact: quadratic in the number of contacts. See
 * doc/theory.md, "Exact contact", several equilibria.
 */
std::vector<BeyondUniqueness> contacts_beyond_uniqueness(const Contacts &contacts,
                                                         const CondensedLine &line,
                                                         const ProximalContacts &proximal,
                                                         const std::vector<ContactStatus> &status);

} // namespace frictionbeam
