// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rigid_stops.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::contact {

namespace {
constexpr double in_common_least = 1e-9; // of the larger force of a pair
}

double RigidStops::force_in_common(const Pair &pair, const Response &response) const {
  const auto force = [&](const unsigned int i) {
    return -sites[i].share() * response.stress[i][0];
  };
  const auto [less, more] = std::minmax({force(pair[0]), force(pair[1])});
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

void RigidStops::release(const Response &response, ProximalSites &proximal) const {
  for (const Pair &pair : pairs) {
    const double force = force_in_common(pair, response);
    if (!(force > 0.))
      continue;
    const auto pressure = [&](const unsigned int i) { return -response.stress[i][0]; };
    const bool first_is_less =
        sites[pair[0]].share() * pressure(pair[0]) < sites[pair[1]].share() * pressure(pair[1]);
    const unsigned int less = pair[first_is_less ? 0 : 1], more = pair[first_is_less ? 1 : 0];
    proximal.centre[more][0] += force / sites[more].share();
    proximal.centre[less].setZero();
    proximal.leave_out(less);
  }
}

} // namespace frictionbeam::contact
