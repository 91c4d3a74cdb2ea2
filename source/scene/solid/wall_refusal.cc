// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/solid/wall_refusal.h"

#include "scene/in_units.h"

namespace frictionbeam {

std::optional<WallRefusal> wall_refusal(const Scene &scene, const Pipe &pipe,
                                        const double bend_radius) {
  const Section &section = scene.sections[pipe.section];
  const std::string of_section = "Section " + section.name, of_pipe = "Pipe " + pipe.name;
  if (section.wall == 0.)
    return WallRefusal{of_section, "Wall", "section '" + section.name + "' by its area and inertia",
                       "an Outer diameter and a Wall", "Outer diameter and Wall"};
  if (section.wall >= section.outer_radius)
    return WallRefusal{of_section, "Wall", "a Wall of half the diameter", "a Wall with a bore",
                       "a smaller Wall"};
  const Material &material = scene.materials[pipe.material];
  if (material.poissons_ratio >= 0.5)
    return WallRefusal{"Material " + material.name, "Poisson's ratio", "Poisson's ratio = 0.5",
                       "less than 0.5 of a solid, whose volume could not change else,", "0.499"};
  if (pipe.end_section)
    return WallRefusal{of_pipe, "End section", "a reducer", "one Section all along",
                       "one Section all along"};
  if (pipe.rigid)
    return WallRefusal{of_pipe, "Rigid", "Rigid = true", "pipes of their own metal", "false"};
  if (pipe.total_mass)
    return WallRefusal{of_pipe, "Mass", "Mass", "the mass by the Material's density",
                       "the Material's density"};
  if (bend_radius > 0. && bend_radius <= section.outer_radius) {
    const std::string bend = "bend of " + in_units(scene.units, bend_radius, "m");
    return WallRefusal{of_pipe, "Route", "a " + bend,
                       "bends of a radius larger than the pipe's own outer radius, so that the "
                       "wall's inner side has room,",
                       "a larger radius for the " + bend};
  }
  return {};
}

} // namespace frictionbeam
