// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/elastic_system.h"
#include "analysis/body/foundation_contacts.h"

namespace frictionbeam {

/**
 * Where Newton's methods on a body's contacts stall: the same problem condensed to them,
 * contact::LocalProblem, which contact::solve_local_contact() solves by other means, as a start for
 * one more attempt. Weak springs at the contacts (1e-6 of the stiffness there) give a body that
 * nothing else holds a flexibility; they have no part in the attempt.
 *
 * Of bodies on one process with few contacts, all rigid or elastic by a closed form and without
 * prescribed pressure.
 *
 * @param forces of the loads, on unconstrained dofs
 * @param tractions out: on the body, in the contacts' axes [Pa]
 * @param u out: displacements with these and the weak springs [m]
 * @return whether there is one; if not, nothing is changed
 */
template <int dim>
bool find_condensed_start(const ContinuumBody<dim> &body, ContinuumSystem &system,
                          const FoundationContacts &contacts, const FoundationState &committed,
                          const ContinuumVector &forces, std::vector<LocalVector> &tractions,
                          ContinuumVector &u);

} // namespace frictionbeam
