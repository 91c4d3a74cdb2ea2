// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/line_factorization.h"
#include "model/contact/contacts.h"

namespace frictionbeam {

/// Factor the mass matrix, with 1 on the diagonal of unknowns without mass.
/// @throws UserError if rounding leaves it without an inverse
void factor_mass(const SparseMatrix &M, LineFactorization &mass);

} // namespace frictionbeam
