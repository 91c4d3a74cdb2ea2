// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/contact/contacts.h"

namespace frictionbeam {

/// Shapes of K phi = w^2 M phi in columns, phi_i^T M phi_i = 1, and their w [rad/s], zero of rigid
/// motions.
struct Modes {
  Eigen::MatrixXd shapes;
  Vector frequencies;
};
/// All modes of a small line.
/// @throws UserError above 600 unknowns, or where an unknown has no mass.
Modes modes_to_damp(const SparseMatrix &K, const SparseMatrix &M);

/**
 * The damping matrix C = sum_i 2 zeta w_i (M phi_i)(M phi_i)^T that gives every mode of K, M the
 * same ratio zeta to critical damping, with phi_i^T M phi_i = 1. Rigid motions have none. It is
 * full, so that it is for small lines.
 * @throws UserError above 600 unknowns, or where an unknown has no mass.
 */
SparseMatrix modal_damping(const SparseMatrix &K, const SparseMatrix &M, const double ratio);

} // namespace frictionbeam
