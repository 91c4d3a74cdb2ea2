// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/opposed_contacts.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace frictionbeam {

namespace {
bool are_opposed(const Contact &one, const Contact &other) {
  constexpr double opposite = -1. + 1e-9;
  return one.vertices[0] == other.vertices[0] && one.axes.x * other.axes.x < opposite;
}

/// Contacts that touch, by the pipe's node.
std::map<unsigned int, std::vector<unsigned int>>
closed_by_node(const Contacts &contacts, const std::function<bool(unsigned int)> &touches) {
  std::map<unsigned int, std::vector<unsigned int>> closed;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (touches(i))
      closed[contacts[i].vertices[0]].push_back(i);
  return closed;
}
} // namespace

bool is_held_opposite(const Contacts &contacts, const LineState &state, const unsigned int i) {
  for (unsigned int k = 0; k < contacts.size(); ++k)
    if (state.contact_status[k] != ContactStatus::open && are_opposed(contacts[k], contacts[i]))
      return true;
  return false;
}

std::vector<bool> idle_halves(const Contacts &contacts,
                              const std::function<bool(unsigned int)> &touches,
                              const std::function<double(unsigned int)> &force) {
  constexpr double no_force = 1e-9; // of the other's
  std::vector<bool> idle(contacts.size(), false);
  for (const auto &[node, closed] : closed_by_node(contacts, touches))
    for (auto i = closed.begin(); i != closed.end(); ++i)
      for (auto k = closed.begin(); k != i; ++k)
        if (!idle[*k] && are_opposed(contacts[*k], contacts[*i])) {
          if (force(*i) <= no_force * force(*k))
            idle[*i] = true;
          else if (force(*k) <= no_force * force(*i))
            idle[*k] = true;
        }
  return idle;
}

std::vector<bool> contacts_that_do_not_hold(const Contacts &contacts,
                                            const std::function<bool(unsigned int)> &touches,
                                            const std::function<double(unsigned int)> &force,
                                            const double nothing) {
  std::vector<bool> result = idle_halves(contacts, touches, force);
  for (const auto &[node, closed] : closed_by_node(contacts, touches))
    for (const unsigned int i : closed)
      result[i] =
          result[i] || (contacts[i].law.has_closed_form() && force(i) <= nothing &&
                        std::none_of(closed.begin(), closed.end(), [&](const unsigned int k) {
                          return are_opposed(contacts[k], contacts[i]);
                        }));
  return result;
}

namespace {
/// What a state says of its contacts.
struct OfState {
  const Contacts &contacts;
  const LineState &state;
  bool touches(const unsigned int i) const {
    return state.contact_status[i] != ContactStatus::open;
  }
  double force(const unsigned int i) const {
    return contacts[i].share() * std::abs(state.contact_stress[i][0]);
  }
};
} // namespace

std::vector<bool> idle_halves(const Contacts &contacts, const LineState &state) {
  const OfState of{contacts, state};
  return idle_halves(
      contacts, [&](const unsigned int i) { return of.touches(i); },
      [&](const unsigned int i) { return of.force(i); });
}

std::vector<bool> contacts_that_do_not_hold(const Contacts &contacts, const LineState &state,
                                            const double nothing) {
  const OfState of{contacts, state};
  return contacts_that_do_not_hold(
      contacts, [&](const unsigned int i) { return of.touches(i); },
      [&](const unsigned int i) { return of.force(i); }, nothing);
}

} // namespace frictionbeam
