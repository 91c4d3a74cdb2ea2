// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/load_course.h"

namespace frictionbeam {

/// Unknowns with mass.
std::vector<bool> unknowns_with_mass(const SparseMatrix &mass);

/// The mass matrix, regular: 1 on the diagonal where there is no mass.
SparseMatrix regular_mass(const SparseMatrix &mass);

/// sum += factor matrix, whose pattern is within that of the sum; rows in the order of columns.
void add_within(const double factor, const SparseMatrix &matrix, SparseMatrix &sum);

/// Set what a state has at the end of a step, at @p time, beside its unknowns and their rates: all
/// degrees of freedom, the loads' factors before any jump there and their derivatives.
void arrive(const Model &model, const LoadCourse &loads, const double time,
            const LoadCourse::Factors &factors, const Vector &imposed, LineState &to);

/// Take over what a solve found out about the contacts.
/// @param before states of the contacts at the beginning
void commit_contacts(ContactResponse &response, const std::vector<ContactStatus> &before,
                     LineState &after);

/// Whether a law without a closed form says that all motion across is slip: it does not stick, and
/// resists.
inline bool slides(const ContactStatus status, const Contact::Strains &stress) {
  return (status == ContactStatus::slip || status == ContactStatus::closed) &&
         (stress[1] != 0. || stress[2] != 0.);
}

/// Wear and impulses of a step with friction elements by their return mapping.
void add_histories(const Contacts &contacts, const LineState &before, LineState &after);

} // namespace frictionbeam
