// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/stress/wall_stress.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

Section section_at(const Scene &scene, const Station &station) {
  const Pipe &pipe = scene.pipes[station.pipe];
  const Section &section = scene.sections[pipe.section];
  return pipe.end_section ? between(section, scene.sections[*pipe.end_section], station.part)
                          : section;
}

WallStress wall_stress(const Section &section, const Motion &force, const double pressure) {
  const auto [N, Vy, Vz, Mx, My, Mz] = force;
  const double outer = section.outer_radius, inner = outer - section.wall,
               ring = outer * outer - inner * inner,
               along = N / section.area + pressure * inner * inner / ring;
  // Unit vector from the centre, in y and z, to where bending stretches most; the neutral axis is
  // across it. Where nothing bends, that across which the shear is largest.
  double y = -Mz, z = My, size = std::hypot(y, z);
  if (size == 0.) {
    y = Vy;
    z = Vz;
    size = std::hypot(y, z);
  }
  if (size == 0.) {
    y = 1.;
    size = 1.;
  }
  y /= size;
  z /= size;
  WallStress result{-1e300, 1e300, 0., 0.};
  for (const double radius : {outer, inner}) {
    const bool is_inside = radius == inner;
    const double round = pressure *
                         (is_inside ? outer * outer + inner * inner : 2. * inner * inner) / ring,
                 through = is_inside ? -pressure : 0.;
    for (const auto &[ey, ez] : {std::array<double, 2>{{y, z}}, {{-y, -z}}, {{z, -y}}, {{-z, y}}}) {
      const double x = along + radius * (My * ez - Mz * ey) / section.inertia,
                   shear = Mx * radius / section.torsion_constant +
                           2. * (Vz * ey - Vy * ez) / section.area,
                   middle = (x + round) / 2., half = std::hypot((x - round) / 2., shear);
      const double most = std::max(middle + half, through),
                   least = std::min(middle - half, through);
      result.most = std::max(result.most, most);
      result.least = std::min(result.least, least);
      result.tresca = std::max(result.tresca, most - least);
      result.von_mises =
          std::max(result.von_mises,
                   std::sqrt(((x - round) * (x - round) + (round - through) * (round - through) +
                              (through - x) * (through - x)) /
                                 2. +
                             3. * shear * shear));
    }
  }
  return result;
}

std::optional<WallStress> elastic_wall_stress(const Scene &scene, const Station &station) {
  const Pipe &pipe = scene.pipes[station.pipe];
  const Section &section = scene.sections[pipe.section];
  if (pipe.rigid || section.wall == 0. || (section.is_inelastic() && !scene.keeps_elastic))
    return {};
  return wall_stress(section_at(scene, station), station.force, station.pressure);
}

} // namespace frictionbeam
