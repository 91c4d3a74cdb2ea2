// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/contact/contacts.h"

namespace frictionbeam {

/**
 * The damping matrix C = sum_i 2 zeta w_i (M phi_i)(M phi_i)^T that gives every mode of K, M the
 * same ratio zeta to critical damping, with phi_i^T M phi_i = 1. Rigid motions have none. It is
 * full, so that it is for small lines.
 * @throws UserError above 600 unknowns, or where an unknown has no mass.
 */
SparseMatrix modal_damping(const SparseMatrix &K, const SparseMatrix &M, const double ratio);

} // namespace frictionbeam
