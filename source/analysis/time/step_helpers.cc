// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/step_helpers.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

std::vector<bool> unknowns_with_mass(const SparseMatrix &mass) {
  std::vector<bool> result(mass.rows());
  for (int i = 0; i < mass.rows(); ++i)
    result[i] = mass.coeff(i, i) > 0.;
  return result;
}

SparseMatrix regular_mass(const SparseMatrix &mass) {
  SparseMatrix result = mass;
  for (int i = 0; i < result.rows(); ++i)
    if (result.coeff(i, i) == 0.)
      result.coeffRef(i, i) = 1.;
  return result;
}

void add_within(const double factor, const SparseMatrix &matrix, SparseMatrix &sum) {
  for (int row = 0; row < matrix.rows(); ++row) {
    SparseMatrix::InnerIterator place(sum, row);
    for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry) {
      while (place && place.col() < entry.col())
        ++place;
      AssertThrow(place && place.col() == entry.col(), dealii::ExcInternalError());
      place.valueRef() += factor * entry.value();
    }
  }
}

void arrive(const Model &model, const LoadCourse &loads, const double time,
            const LoadCourse::Factors &factors, const Vector &imposed, LineState &to) {
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += imposed;
  to.time = time;
  to.load_factors = factors;
  loads.set_rates(to, LoadCourse::Side::before);
}

void commit_contacts(ContactResponse &response, const std::vector<ContactStatus> &before,
                     LineState &after) {
  std::swap(after.contacts, response.state);
  after.contact_stress = response.stress;
  after.contact_status = response.status;
  after.events.clear();
  for (unsigned int i = 0; i < before.size(); ++i)
    if (after.contact_status[i] != before[i])
      after.events.push_back({after.time, i, after.contact_status[i]});
}

namespace {
/// Size of what slips across, over the length; of a law without a closed form all that moves where
/// it resists without sticking.
double slip_in_step(const Contact &contact, const unsigned int i, const LineState &before,
                    const LineState &after) {
  if (!contact.law.has_closed_form())
    return slides(after.contact_status[i], after.contact_stress[i])
               ? (after.contacts.strain[i] - before.contacts.strain[i]).segment<2>(1).norm()
               : 0.;
  const FrictionThreshold &law = contact.law.closed_form();
  const auto slip = [&](const int place) {
    return after.contacts.internal[contact.state_offset + place] -
           before.contacts.internal[contact.state_offset + place];
  };
  return std::hypot(slip(law.slip_y), slip(law.slip_z));
}
} // namespace

void add_histories(const Contacts &contacts, const LineState &before, LineState &after) {
  const double step = after.time - before.time;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Contact &contact = contacts[i];
    const double normal =
        -contact.share() / 2. * (before.contact_stress[i][0] + after.contact_stress[i][0]);
    after.contacts.impulse[i] = before.contacts.impulse[i] + step * normal;
    after.contacts.wear[i] = before.contacts.wear[i];
    if (after.contact_status[i] != ContactStatus::open)
      after.contacts.wear[i] +=
          std::max(0., normal) * contact.length * slip_in_step(contact, i, before, after);
  }
}

} // namespace frictionbeam
