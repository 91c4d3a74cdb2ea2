// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "proximal_sites.h"

namespace frictionbeam::contact {

/// Rigid stops, whose halves may both press on what they hold, with a force in common that nothing
/// determines.
class RigidStops {
public:
  explicit RigidStops(const SiteList &sites) : sites(sites), pairs(rigid_pairs(sites)) {}

  /// Whether halves press on each other.
  bool press(const Response &response) const;
  /**
   * Begin anew without what the halves have in common, and without the one that presses less: were
   * both closed, Newton's method would share a change of the force between them, and the friction
   * of both, which nothing determines, would depend on its path. That the half may be left out is
   * the certificate's to say, which knows nothing of it.
   */
  void release(const Response &response, ProximalSites &proximal) const;

  /// Leave out one half of each pair that press on each other. @param stronger that with more force
  void leave_out(const Response &response, const bool stronger, ProximalSites &proximal) const;

  using Pair = std::array<unsigned int, 2>; ///< the halves of a stop

  /// A stop that is narrower than what it holds: no motion opens one half without closing the
  /// other.
  std::optional<Pair> overlapping(const ProximalSites &proximal,
                                  const ImposedMotion &imposed) const;

private:
  double force_of(const unsigned int half, const Response &response) const; ///< normal [N]
  /// Less and more pressed half of a pair.
  Pair by_force(const Pair &pair, const Response &response) const;
  /// With which both halves press on each other [N]; 0 if they do not.
  double force_in_common(const Pair &pair, const Response &response) const;

  const SiteList &sites;
  const std::vector<Pair> pairs;
};

} // namespace frictionbeam::contact
