// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/undetermined_forces.h"

#include "base/algebra/dense_algebra.h"
#include "base/joined.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace frictionbeam {

namespace {

using Shares = std::map<int, double>; ///< by unknown

/// A force that a contact may change by itself, as what it does to the free unknowns, or a motion
/// of them that it does not let happen.
struct FreeForce {
  unsigned int contact;
  Shares on_unknowns; ///< of unit size
};

double product(const Shares &a, const Shares &b) {
  double sum = 0.;
  for (const auto &[unknown, share] : a)
    if (const auto other = b.find(unknown); other != b.end())
      sum += share * other->second;
  return sum;
}

double size_of(const Shares &a) { return std::sqrt(product(a, a)); }

/// What is not in the span of an orthonormal basis.
Shares without(Shares rest, const std::vector<Shares> &basis) {
  for (const Shares &direction : basis) {
    const double part = product(rest, direction);
    for (const auto &[unknown, share] : direction)
      rest[unknown] -= part * share;
  }
  return rest;
}

/// Whether a contact at its limit has moved at all since it closed, by more than rounding.
/// @param largest displacement of the line
bool has_slipped(const Contact &contact, const unsigned int i, const LineState &state,
                 const double largest) {
  const Contact::Strains since = state.contacts.strain[i] - state.contacts.touch[i];
  return contact.length * since.segment<2>(1).norm() >
         std::max(1e-9 * largest, 1e-13 * contact.length);
}

enum class Side { forces, held_motions };

Eigen::Vector3d direction_of_slip(const Contact::Strains &stress) {
  return Eigen::Vector3d(0., stress[1], stress[2]).normalized();
}

/// Stresses that may change without the contact yielding: rigid ones alone, for an elastic one
/// follows the motion. In slip the friction force follows the normal force, and the normal is held.
/// @param largest displacement of the line @param keeps_still although it has slipped: what it
/// meets friction along is free
std::vector<Eigen::Vector3d> rigid_directions(const Contact &contact, const unsigned int i,
                                              const LineState &state, const double largest,
                                              const Side side, const bool keeps_still) {
  const FrictionThreshold &law = contact.law.closed_form();
  std::vector<Eigen::Vector3d> result;
  const bool rigid_normal = !std::isfinite(law.axial_rigidity);
  const bool slips = state.contact_status[i] == ContactStatus::slip &&
                     has_slipped(contact, i, state, largest),
             sticks = !slips && state.contact_status[i] != ContactStatus::closed;
  if (slips) {
    if (keeps_still)
      result.push_back(direction_of_slip(state.contact_stress[i]));
    if (rigid_normal)
      result.push_back(side == Side::forces && !keeps_still
                           ? state.contact_stress[i].head<3>().eval()
                           : Eigen::Vector3d::UnitX().eval());
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

/// Of unit size; nothing if the line cannot move that way: it is the restraint's.
std::optional<FreeForce> free_force(const Contact &contact, const unsigned int i,
                                    const Eigen::Vector3d &direction) {
  const Vector row = contact.length * contact.B.topRows<3>().transpose() * direction;
  if (!(row.norm() > no_component * direction.norm()))
    return {};
  FreeForce force{i, {}};
  for (Eigen::Index j = 0; j < row.size(); ++j)
    force.on_unknowns[contact.unknowns[j]] += row[j] / row.norm();
  return force;
}

/// @param keeps_still of all contacts; empty: none
std::vector<FreeForce> free_forces(const Contacts &contacts, const LineState &state,
                                   const Side side, const std::vector<bool> &keeps_still = {}) {
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
    for (const Eigen::Vector3d &direction : rigid_directions(
             contacts[i], i, state, moved, side, !keeps_still.empty() && keeps_still[i]))
      if (auto force = free_force(contacts[i], i, direction))
        result.push_back(std::move(*force));
  }
  return result;
}

/// Which contacts at their limit cannot slide on, since others hold their points in that direction.
std::vector<bool> kept_still(const Contacts &contacts, const LineState &state) {
  constexpr double dependent = 1e-6; // of a unit vector
  const std::vector<FreeForce> held = free_forces(contacts, state, Side::held_motions);
  std::map<int, std::vector<unsigned int>> at; // those that hold an unknown
  for (unsigned int k = 0; k < held.size(); ++k)
    for (const auto &[unknown, share] : held[k].on_unknowns)
      at[unknown].push_back(k);
  std::vector<bool> result(contacts.size(), false);
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    if (!contacts[i].law.has_closed_form() || state.contact_status[i] != ContactStatus::slip ||
        std::isfinite(contacts[i].law.closed_form().shear_rigidity_y))
      continue;
    const auto slip = free_force(contacts[i], i, direction_of_slip(state.contact_stress[i]));
    if (!slip)
      continue;
    std::set<unsigned int> holding;
    for (const auto &[unknown, share] : slip->on_unknowns)
      if (const auto known = at.find(unknown); known != at.end())
        for (const unsigned int k : known->second)
          if (held[k].contact != i)
            holding.insert(k);
    std::vector<Shares> basis; // of what they hold, orthonormal
    for (const unsigned int k : holding)
      if (auto rest = without(held[k].on_unknowns, basis); size_of(rest) > dependent) {
        const double size = size_of(rest);
        for (auto &[unknown, share] : rest)
          share /= size;
        basis.push_back(std::move(rest));
      }
    result[i] = size_of(without(slip->on_unknowns, basis)) < dependent;
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

/// Contacts with forces, or motions that they hold, that depend on each other.
std::set<unsigned int> dependent_contacts(const std::vector<FreeForce> &forces) {
  constexpr double dependent = 1e-12, takes_part = 1e-6;
  std::set<unsigned int> undetermined;
  for (const std::vector<unsigned int> &group : groups_of(forces)) {
    const Eigen::Index n = group.size();
    Eigen::MatrixXd products(n, n);
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b < n; ++b)
        products(a, b) = product(forces[group[a]].on_unknowns, forces[group[b]].on_unknowns);
    const SymmetricEigen eigen = symmetric_eigen(products);
    for (Eigen::Index k = 0; k < n && eigen.values[k] < dependent * n; ++k)
      for (Eigen::Index a = 0; a < n; ++a)
        if (std::abs(eigen.vectors(a, k)) > takes_part)
          undetermined.insert(forces[group[a]].contact);
  }
  return undetermined;
}

} // namespace

std::vector<unsigned int> contacts_with_undetermined_forces(const Contacts &contacts,
                                                            const LineState &state) {
  const std::vector<bool> keeps_still = kept_still(contacts, state);
  std::set<unsigned int> undetermined =
      dependent_contacts(free_forces(contacts, state, Side::forces, keeps_still));
  undetermined.merge(
      dependent_contacts(free_forces(contacts, state, Side::held_motions, keeps_still)));
  return {undetermined.begin(), undetermined.end()};
}

bool share_unknowns(const Contacts &contacts) {
  std::set<int> taken;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    for (const int unknown : contacts[i].unknowns)
      if (!taken.insert(unknown).second)
        return true;
  return false;
}

} // namespace frictionbeam
