// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"
#include <frictionbeam/contact/line_factorization.h>

namespace frictionbeam {

/// Factor the mass matrix, with 1 on the diagonal of unknowns without mass.
/// @throws UserError if rounding leaves it without an inverse
void factor_mass(const SparseMatrix &M, contact::LineFactorization &mass);

/// What condenses unknowns without mass has no place for dashpots on them, which need a velocity.
/// @param reader entry that condenses, for the message
/// @throws UserError that names the dashpot
void check_dashpots_have_mass(const Model &model, const std::string &reader);

} // namespace frictionbeam
