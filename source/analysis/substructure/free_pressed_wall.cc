// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/substructure/free_pressed_wall.h"

#include "analysis/algebra/elastic_system.h"
#include "mesh/solid/held_points.h"

namespace frictionbeam {

using namespace dealii;

ContinuumVector free_pressed_wall(const Scene &body_scene, const PipeWall &wall) {
  Scene free_scene = body_scene;
  free_scene.continuum->sections.clear();
  free_scene.continuum->contacts.clear();
  free_scene.continuum->holds = holds_at_points(wall);
  ContinuumBody<3> body(free_scene, wall.mesh);
  body.distribute();
  std::vector<ContinuumVector> field = {volume_gradient(wall, body)};
  const bool is_solved = make_condensed_system(body)->solve_all(field);
  AssertThrow(is_solved, ExcInternalError());
  body.constraints.distribute(field[0]);
  field[0].update_ghost_values();
  return field[0];
}

} // namespace frictionbeam
