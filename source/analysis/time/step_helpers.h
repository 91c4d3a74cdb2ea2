// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"

namespace frictionbeam {

/// Unknowns with mass.
std::vector<bool> unknowns_with_mass(const SparseMatrix &mass);

/// The mass matrix, regular: 1 on the diagonal where there is no mass.
SparseMatrix regular_mass(const SparseMatrix &mass);

/// Take over what a solve found out about the contacts.
void commit_contacts(ContactResponse &response, const LineState &before, LineState &after);

/// Wear and impulses of a step with friction elements by their return mapping.
void add_histories(const Contacts &contacts, const LineState &before, LineState &after);

} // namespace frictionbeam
