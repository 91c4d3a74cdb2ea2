// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/increment/contact_watch.h"

#include "analysis/contact/opposed_contacts.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

bool is_rigid_stop(const Model &model, const Contact &contact) {
  if (!contact.law.is_rigid_along_normal() || contact.platen_force != 0.)
    return false;
  for (unsigned int j = 0; j < contact.unknowns.size(); ++j) {
    const auto column = contact.B.col(j);
    if (std::abs(column[0]) > no_component * column.norm() &&
        !(model.linear.mass().coeff(contact.unknowns[j], contact.unknowns[j]) > 0.))
      return false;
  }
  return true;
}

void ContactsBefore::take(const Model &model, const LineState &state) {
  constexpr double rounding = 1e-12; // of what a gap is made of, and of the line's displacements
  constexpr double apart = -std::numeric_limits<double>::infinity();
  const double moved = state.dofs.lpNorm<Eigen::Infinity>();
  status = state.contact_status;
  if (since.empty()) {
    other_half.assign(status.size(), -1);
    for (const auto &[one, other] : contact::rigid_pairs(model.contacts)) {
      other_half[one] = other;
      other_half[other] = one;
    }
  }
  since.resize(status.size(), state.time);
  for (unsigned int i = 0; i < since.size(); ++i) {
    const Contact &contact = model.contacts[i];
    const double way = contact.length * state.contacts.strain[i][0], gap = contact.law.gap();
    const bool is_open = status[i] == ContactStatus::open;
    if (is_open && way + gap > rounding * (std::abs(way) + std::abs(gap) + moved))
      since[i] = apart;
    else if (!is_open || since[i] != apart) // else it has come near, and is about to touch
      since[i] = state.time;
  }
}

std::vector<unsigned int> closed_in(const ContactsBefore &contacts,
                                    const std::vector<ContactEvent> &events) {
  constexpr double no_time = 1e-9; // of the run's
  std::vector<unsigned int> closed;
  if (events.empty())
    return closed;
  ContactsBefore before = contacts;
  for (const ContactEvent &event : events) {
    const unsigned int i = event.contact;
    const bool was_open = before.status[i] == ContactStatus::open,
               is_open = event.status == ContactStatus::open;
    const int other = before.other_half[i];
    const bool touched = before.since[i] > -std::numeric_limits<double>::infinity() && other >= 0 &&
                         (before.status[other] != ContactStatus::open ||
                          event.time - before.since[other] <= no_time * event.time);
    if (was_open && !is_open && !touched && event.time - before.since[i] > no_time * event.time)
      closed.push_back(i);
    if (is_open && !was_open)
      before.since[i] = event.time;
    before.status[i] = event.status;
  }
  return closed;
}

void watch_contacts(const Model &model, const ContactsBefore &before, const LineState &after,
                    StepReport &report) {
  const unsigned int n = model.contacts.size();
  report.margins.resize(n);
  for (const unsigned int i : closed_in(before, after.events))
    if (is_rigid_stop(model, model.contacts[i])) {
      const auto place = std::lower_bound(report.struck.begin(), report.struck.end(), i);
      if (place == report.struck.end() || *place != i)
        report.struck.insert(place, i);
    }
  for (unsigned int i = 0; i < n; ++i) {
    const Contact &contact = model.contacts[i];
    if (!contact.law.has_closed_form())
      continue;
    const FrictionThreshold &law = contact.law.closed_form();
    ContactMargin &margin = report.margins[i];
    const Contact::Strains &stress = after.contact_stress[i];
    const double force = -contact.share() * stress[0];
    if (after.contact_status[i] == ContactStatus::open) {
      margin.opening = 0.;
      margin.closing = std::min(
          margin.closing, std::max(0., contact.length * after.contacts.strain[i][0] + law.gap));
      continue;
    }
    margin.closing = 0.;
    margin.opening = std::min(margin.opening, std::max(0., force));
    if (after.contact_status[i] == ContactStatus::slip)
      margin.slip = 0.;
    else if (after.contact_status[i] == ContactStatus::stick && stress[0] < 0.)
      margin.slip =
          std::min(margin.slip, std::max(0., 1. - std::hypot(stress[1], stress[2]) /
                                                      (law.static_friction * -stress[0])));
  }
}

} // namespace frictionbeam
