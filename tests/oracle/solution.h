// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "contacts.h"

#include <map>
#include <memory>

namespace oracle {

/// The line at the end of a step.
struct State {
  Vector motion;             ///< of all nodes
  std::vector<Real> factors; ///< of the loads, histories included, and of the hangers
  std::vector<Contact> contacts;
  bool sure = true; ///< the contact solver has converged in all increments so far
};

/// Forces of the contacts at times, in the contacts' axes.
using Starts = std::map<double, std::vector<Vec3>>;

/// The whole load sequence, static steps only.
struct Solution {
  std::shared_ptr<const Scene> scene; ///< with hangers sized
  std::shared_ptr<const Frame> frame;
  bool hanger_pushes = false; ///< one that was to be sized: there is no answer
  /// Something moves freely where no contact holds it: what is divided by is rounding.
  bool hangs_on_contacts = false;
  std::vector<State> steps;
  std::vector<double> frequencies; ///< [Hz], if modes are asked for
};

/// @param starts where the contact solver begins in each increment; empty: at the forces of the one
/// before
Solution solve(const Scene &scene, const Starts &starts = {});

} // namespace oracle
