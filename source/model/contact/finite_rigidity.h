// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/contact/contacts.h"

namespace frictionbeam {

/**
 * For methods that need a stiffness where the scene has none: rigidities of rigid contacts become
 * 1e7 times the line's own stiffness at the contact, so that what the contact gives is below a
 * millionth of how far the line is bent. The elastic stiffness of that is still known to nine
 * digits.
 * Where any contact has friction, all keep what their law takes: Newton's method on return mapping
 * would lose lines that it solves with less.
 */
void make_rigid_contacts_finite(const SparseMatrix &stiffness, Contacts &contacts);

} // namespace frictionbeam
