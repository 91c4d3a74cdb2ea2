// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/solid/wall_doubts.h"

#include "results/text.h"

#include <algorithm>

namespace frictionbeam {

std::string doubt_of_stresses(const Scene &scene, const PipeWall &wall,
                              const std::vector<WallFrame> &frames) {
  double worst = 1.; // of the yield stress
  std::string text;
  for (const WallFrame &frame : frames)
    for (std::size_t r = 0; r < wall.rings.size(); ++r) {
      const Pipe &pipe = scene.pipes[wall.segments[wall.rings[r].segment].pipe];
      const Material &material = scene.materials[pipe.material];
      const RingState &ring = frame.rings[r];
      const double stress = std::max(ring.largest_mises(0), ring.largest_mises(1));
      if (material.yield_stress <= 0. || stress <= worst * material.yield_stress)
        continue;
      worst = stress / material.yield_stress;
      text = "Pipe " + pipe.name + ", " +
             rounded_number(wall.rings[r].s / scene.units.factor("m"), 4) + " " +
             scene.units.name("m") + " along the pipes, step " + scene.steps[frame.step].name +
             ": the equivalent stress of the wall is " +
             rounded_number(stress / scene.units.factor("Pa"), 3) + " " + scene.units.name("Pa") +
             ", " + rounded_number(worst, 3) + " times the Yield stress of material " +
             material.name + ", while the wall is taken for elastic.";
    }
  return text;
}

} // namespace frictionbeam
