// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/contact/contacts.h"

#include <array>

namespace frictionbeam {

/// Which strains of a contact are held as if rigid.
using HeldStrains = std::array<bool, n_support_strains>;

/**
 * Stiffness s in s b b^T that holds the strains e = b^T q of rigid contacts in a matrix of the
 * whole line, 0 for those that are not held: 1e8 times the stiffness k that the line, held at all
 * other contacts, opposes to a force along b itself, but no less than the largest of the matrix.
 *
 * Of the motion along b a part k/s is left. Rounding of s b b^T disturbs the other motions of the
 * same unknowns, unless b is along one of them, by 1e-16 s: with 1e8 times the largest stiffness
 * of the line in place of k, modes of a pipe on a pipe, on a platen or on an inclined plane were
 * wrong by a percent. To find k, all are held by stiffnesses of the matrix's own size; what they
 * make up of the answer is taken off again (doc/theory.md, "Modes and spectra").
 *
 * @param A positive definite but for what is held, with the contacts' places in its pattern
 */
std::vector<std::array<double, n_support_strains>>
rigid_holds(const SparseMatrix &A, const Contacts &contacts, const std::vector<HeldStrains> &held);

} // namespace frictionbeam
