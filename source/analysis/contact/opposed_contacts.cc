// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/opposed_contacts.h"

#include <cmath>
#include <map>

namespace frictionbeam {

std::vector<bool> idle_halves(const Contacts &contacts, const LineState &state) {
  const auto force = [&](const unsigned int i) { // [N]
    return contacts[i].share() * std::abs(state.contact_stress[i][0]);
  };
  constexpr double opposite = -1. + 1e-9, no_force = 1e-9; // of the other's
  std::vector<bool> idle(contacts.size(), false);
  std::map<unsigned int, std::vector<unsigned int>> closed; // by the pipe's node
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    if (state.contact_status[i] == ContactStatus::open)
      continue;
    auto &others = closed[contacts[i].vertices[0]];
    for (const unsigned int k : others)
      if (!idle[k] && contacts[k].axes.x * contacts[i].axes.x < opposite) {
        if (force(i) <= no_force * force(k))
          idle[i] = true;
        else if (force(k) <= no_force * force(i))
          idle[k] = true;
      }
    others.push_back(i);
  }
  return idle;
}

std::vector<std::array<unsigned int, 2>> rigid_pairs(const Contacts &contacts) {
  constexpr double same = 1e-12;
  std::vector<std::array<unsigned int, 2>> pairs;
  std::map<std::vector<int>, std::vector<unsigned int>> rigid; // by their unknowns
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Contact &contact = contacts[i];
    if (!contact.law.is_rigid_along_normal() || contact.platen_force != 0.)
      continue;
    const Eigen::RowVectorXd normal = contact.length * contact.B_reduced.row(0);
    auto &others = rigid[contact.unknowns];
    for (const unsigned int k : others) {
      const Eigen::RowVectorXd other = contacts[k].length * contacts[k].B_reduced.row(0);
      if ((normal + other).norm() <= same * normal.norm())
        pairs.push_back({k, i});
    }
    others.push_back(i);
  }
  return pairs;
}

} // namespace frictionbeam
