// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/held_directions.h"

#include "scene/support_pair.h"

namespace frictionbeam {

namespace {

Vector3 translation(const Motion &motion) { return Vector3({motion[0], motion[1], motion[2]}); }

} // namespace

std::vector<Vector3> held_directions(const Scene &scene, const RestraintInfo &info,
                                     const Station &station) {
  std::vector<Vector3> ways;
  for (const Spring &spring : scene.springs)
    if (spring.name == info.name) {
      for (unsigned int d = 0; d < 3; ++d)
        if (spring.stiffness[d] + spring.damping[d] > 0.)
          ways.push_back(translation(spring.directions[d]));
      if (ways.empty() && spring.preload > 0.) // of a constant hanger
        ways.push_back(translation(spring.directions[2]));
      return ways;
    }
  const Restraint *restraint = nullptr;
  for (const Restraint &one : scene.restraints)
    if (is_place_of(info.name, one.name) &&
        (restraint == nullptr || one.name.size() > restraint->name.size()))
      restraint = &one;
  if (restraint == nullptr)
    return ways;
  for (unsigned int d = 0; d < 3; ++d)
    if (restraint->fixed[d])
      ways.push_back(restraint->axes[d]);
  for (const Direction &direction : restraint->translations)
    ways.push_back(direction.kind == Direction::Kind::global ? direction.vector
                   : direction.kind == Direction::Kind::along
                       ? cross_product_3d(station.y, station.z)
                       : station.y);
  return ways;
}

} // namespace frictionbeam
