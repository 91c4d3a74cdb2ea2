// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/undetermined_forces.h"

#include "base/joined.h"
#include "base/numbers.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace frictionbeam {

namespace {

/// A force that a contact may change by itself, as what it does to the free unknowns.
struct FreeForce {
  unsigned int contact;
  std::map<int, double> on_unknowns; ///< of unit size
};

/// Whether a contact at its limit has moved at all since it closed, by more than rounding.
/// @param largest displacement of the line
bool has_slipped(const Contact &contact, const unsigned int i, const LineState &state,
                 const double largest) {
  const Contact::Strains since = state.contacts.strain[i] - state.contacts.touch[i];
  return contact.length * since.segment<2>(1).norm() >
         std::max(1e-9 * largest, 1e-13 * contact.length);
}

/// Stresses that may change without the contact yielding: rigid ones alone, for an elastic one
/// follows the motion. In slip the friction force follows the normal force.
/// @param largest displacement of the line
std::vector<Eigen::Vector3d> rigid_directions(const Contact &contact, const unsigned int i,
                                              const LineState &state, const double largest) {
  const FrictionThreshold &law = contact.law.closed_form();
  std::vector<Eigen::Vector3d> result;
  const bool rigid_normal = !std::isfinite(law.axial_rigidity);
  const bool slips = state.contact_status[i] == ContactStatus::slip &&
                     has_slipped(contact, i, state, largest),
             sticks = !slips && state.contact_status[i] != ContactStatus::closed;
  if (slips) {
    if (rigid_normal)
      result.push_back(state.contact_stress[i].head<3>());
    return result;
  }
  if (rigid_normal)
    result.push_back(Eigen::Vector3d::UnitX());
  if (sticks && !std::isfinite(law.shear_rigidity_y))
    result.push_back(Eigen::Vector3d::UnitY());
  if (sticks && !std::isfinite(law.shear_rigidity_z))
    result.push_back(Eigen::Vector3d::UnitZ());
  return result;
}

std::vector<FreeForce> free_forces(const Contacts &contacts, const LineState &state) {
  constexpr double no_force = 1e-9; // of the largest
  const double moved = state.dofs.size() > 0 ? state.dofs.lpNorm<Eigen::Infinity>() : 0.;
  double largest = 0.;
  for (const Contact::Strains &stress : state.contact_stress)
    largest = std::max(largest, stress.head<3>().norm());
  std::vector<FreeForce> result;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    if (!contacts[i].law.has_closed_form() || state.contact_status[i] == ContactStatus::open ||
        !(std::abs(state.contact_stress[i][0]) > no_force * largest))
      continue;
    for (const Eigen::Vector3d &direction : rigid_directions(contacts[i], i, state, moved)) {
      const Vector row = contacts[i].length * contacts[i].B.topRows<3>().transpose() * direction;
      if (!(row.norm() > no_component * direction.norm()))
        continue; // nothing moves that way: it is the restraint's
      FreeForce force{i, {}};
      for (Eigen::Index j = 0; j < row.size(); ++j)
        force.on_unknowns[contacts[i].unknowns[j]] += row[j] / row.norm();
      result.push_back(force);
    }
  }
  return result;
}

/// Forces that have unknowns in common, directly or by way of others.
std::vector<std::vector<unsigned int>> groups_of(const std::vector<FreeForce> &forces) {
  Joined joined(forces.size());
  std::map<int, unsigned int> first;
  for (unsigned int i = 0; i < forces.size(); ++i)
    for (const auto &[unknown, share] : forces[i].on_unknowns)
      joined.join(i, first.try_emplace(unknown, i).first->second);
  std::map<unsigned int, std::vector<unsigned int>> groups;
  for (unsigned int i = 0; i < forces.size(); ++i)
    groups[joined.find(i)].push_back(i);
  std::vector<std::vector<unsigned int>> result;
  for (const auto &group : groups)
    result.push_back(group.second);
  return result;
}

} // namespace

std::vector<unsigned int> contacts_with_undetermined_forces(const Contacts &contacts,
                                                            const LineState &state) {
  constexpr double dependent = 1e-12, takes_part = 1e-6;
  const std::vector<FreeForce> forces = free_forces(contacts, state);
  std::set<unsigned int> undetermined;
  for (const std::vector<unsigned int> &group : groups_of(forces)) {
    const Eigen::Index n = group.size();
    Eigen::MatrixXd products(n, n);
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b < n; ++b) {
        products(a, b) = 0.;
        const auto &other = forces[group[b]].on_unknowns;
        for (const auto &[unknown, share] : forces[group[a]].on_unknowns)
          if (const auto entry = other.find(unknown); entry != other.end())
            products(a, b) += share * entry->second;
      }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(products);
    for (Eigen::Index k = 0; k < n && eigen.eigenvalues()[k] < dependent * n; ++k)
      for (Eigen::Index a = 0; a < n; ++a)
        if (std::abs(eigen.eigenvectors()(a, k)) > takes_part)
          undetermined.insert(forces[group[a]].contact);
  }
  return {undetermined.begin(), undetermined.end()};
}

} // namespace frictionbeam
