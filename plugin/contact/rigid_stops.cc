// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rigid_stops.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::contact {

namespace {
constexpr double in_common_least = 1e-9; // of the larger force of a pair
}

double RigidStops::force_of(const unsigned int half, const Response &response) const {
  return -sites[half].share() * response.stress[half][0];
}

double RigidStops::force_in_common(const Pair &pair, const Response &response) const {
  const auto [weaker, stronger] = by_force(pair, response);
  const double less = force_of(weaker, response), more = force_of(stronger, response);
  return less > in_common_least * more ? less : 0.;
}

std::optional<RigidStops::Pair> RigidStops::overlapping(const ProximalSites &proximal,
                                                        const ImposedMotion &imposed) const {
  constexpr double rounding = 1e-12; // of the gaps
  for (const Pair &pair : pairs) {
    double width = 0., size = 0.;
    for (const unsigned int i : pair) {
      const double moved = imposed.strain.empty() ? 0. : sites[i].length * imposed.strain[i][0];
      width += proximal.gap_of(i) + moved;
      size += std::abs(proximal.gap_of(i)) + std::abs(moved);
    }
    if (width < -rounding * size)
      return pair;
  }
  return {};
}

bool RigidStops::press(const Response &response) const {
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const Pair &pair) { return force_in_common(pair, response) > 0.; });
}

RigidStops::Pair RigidStops::by_force(const Pair &pair, const Response &response) const {
  return force_of(pair[0], response) < force_of(pair[1], response) ? pair : Pair{pair[1], pair[0]};
}

void RigidStops::release(const Response &response, ProximalSites &proximal) const {
  for (const Pair &pair : pairs) {
    const double force = force_in_common(pair, response);
    if (!(force > 0.))
      continue;
    const auto [less, more] = by_force(pair, response);
    proximal.centre[more][0] += force / sites[more].share();
    proximal.centre[less].setZero();
    proximal.leave_out(less);
  }
}

void RigidStops::leave_out(const Response &response, const bool stronger,
                           ProximalSites &proximal) const {
  for (const Pair &pair : pairs)
    if (force_in_common(pair, response) > 0.)
      proximal.leave_out(by_force(pair, response)[stronger ? 1 : 0]);
}

} // namespace frictionbeam::contact
