// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/solid/wall_doubts.h"

#include "mesh/solid/wall_cells.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// Of a ring: its pipe and how far along it, in words.
std::string place_of(const WallRing &ring, const PipeWall &wall, const Scene &scene) {
  const unsigned int pipe = wall.segments[ring.segment].pipe;
  const double s = std::max(0., ring.s - wall.pipe_start[pipe]); // its first one: to rounding
  return scene.pipes[pipe].name + ", s = " + rounded_number(s / scene.units.factor("m"), 4) + " " +
         scene.units.name("m");
}

} // namespace

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
      text = "Pipe " + place_of(wall.rings[r], wall, scene) + ", step " +
             scene.steps[frame.step].name + ": the equivalent stress of the wall is " +
             rounded_number(stress / scene.units.factor("Pa"), 3) + " " + scene.units.name("Pa") +
             ", " + rounded_number(worst, 3) + " times the Yield stress of material " +
             material.name + ", while the wall is taken for elastic.";
    }
  return text;
}

std::string doubt_of_bore(const Scene &scene, const PipeWall &wall,
                          const std::vector<WallFrame> &frames) {
  double worst = 0.05; // of the equivalent stress
  std::string text;
  const double Pa = scene.units.factor("Pa");
  for (const WallFrame &frame : frames)
    for (std::size_t r = 2; r + 2 < wall.rings.size(); ++r) {
      const RingState &ring = frame.rings[r];
      const double miss = std::abs(ring.on_bore + ring.pressure);
      if (ring.pressure == 0. || miss <= worst * ring.largest_mises(0))
        continue;
      worst = miss / ring.largest_mises(0);
      text = "Pipe " + place_of(wall.rings[r], wall, scene) + ", step " +
             scene.steps[frame.step].name + ": the radial stress of the bore is " +
             rounded_number(ring.on_bore / Pa, 3) + " " + scene.units.name("Pa") +
             ", where the pressure makes " + rounded_number(-ring.pressure / Pa, 3) +
             ": cells through the wall are too coarse for its stresses. Take more of "
             "Solid/Cells through.";
    }
  return text;
}

KnownError error_of_cells(const Scene &scene, const std::string &name) {
  if (!scene.has_bend())
    return {{}, "what cells leave is known of bends, of which there is none; Accuracy measures it"};
  const SolidSettings &solid = scene.solid;
  const Section &section = scene.sections[scene.pipes.front().section];
  const auto error = flexibility_error(solid.degree, solid.cells_around,
                                       section.outer_radius / section.wall - 0.5);
  if (!error)
    return {{}, "cells of degree 1 lock"};
  return {error, std::to_string(solid.cells_around) + " cells of degree " +
                     std::to_string(solid.degree) + " around " + name};
}

HowWellKnown how_well_known_of_wall(const Scene &scene) {
  HowWellKnown known;
  known.increments =
      scene.supports.empty()
          ? KnownError{0., "nothing slips"}
          : KnownError{{}, "supports may slip within increments; Accuracy measures it"};
  known.time_step = {0., "there is no transient step"};
  known.cells = error_of_cells(scene, "the wall");
  return known;
}

} // namespace frictionbeam
