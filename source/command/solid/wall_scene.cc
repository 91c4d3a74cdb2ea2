// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/solid/wall_scene.h"

#include "base/processes.h"
#include "base/user_error.h"
#include "results/support_force.h"
#include "scene/steps/step_factors.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

const Contact &contact_of(const Model &line, const WallPatch &patch) {
  for (unsigned int i = 0; i < line.contacts.size(); ++i)
    if (line.contacts[i].support == patch.support && line.contacts[i].site == patch.site)
      return line.contacts[i];
  AssertThrow(false, ExcInternalError());
  return line.contacts[0];
}

ContinuumContact contact_on(const Scene &scene, const Model &line, const PipeWall &wall,
                            const WallPatch &patch) {
  const FrictionSupport &support = scene.supports[patch.support];
  const WallRing &ring = wall.rings[wall.ring_at(patch.vertex)];
  const LocalAxes &axes = contact_of(line, patch).axes; // x to the ground
  ContinuumContact contact;
  contact.part = patch.part;
  contact.law = support.law;
  contact.parameters = support.parameters_of(contact_of(line, patch).place);
  contact.patch = ContinuumPatch{
      {{axes.x, axes.z, axes.y}}, ring.centre, ring.tangent, patch.outward, patch.least_cosine()};
  return contact;
}

std::vector<Motion> held_motions(const Restraint &restraint, const Site &site) {
  std::vector<Motion> held;
  for (const Tensor<1, 6> &direction : held_directions(restraint, site)) {
    held.emplace_back();
    for (unsigned int c = 0; c < 6; ++c)
      held.back()[c] = direction[c];
  }
  return held;
}

/// Call with the ring and the directions of each place that is held.
template <typename Call>
void for_each_restraint(const Scene &scene, const Model &line, const PipeWall &wall,
                        const Call &call) {
  for (std::size_t i = 0; i < scene.restraints.size(); ++i)
    for (const Site &site : line.mesh.restraints[i])
      call(wall.rings[wall.ring_at(site.vertex)], held_motions(scene.restraints[i], site));
}

ContinuumStep as_step_of_body(const Scene &scene, const LoadStep &step) {
  ContinuumStep result;
  result.name = step.name;
  result.n_increments = step.n_increments;
  result.factors = declared_factors(scene, step);
  if (result.factors.empty())
    result.factors = {0.};
  return result;
}

} // namespace

Scene scene_of_wall(const Scene &scene, const Model &line, const PipeWall &wall) {
  ContinuumScene body;
  body.dimension = 3;
  for (const Pipe &pipe : scene.pipes) {
    const Material &material = scene.materials[pipe.material];
    body.materials.push_back({material.youngs_modulus, material.poissons_ratio});
  }
  for_each_restraint(scene, line, wall, [&](const WallRing &ring, const std::vector<Motion> &held) {
    if (held.size() == 6)
      body.sections.push_back({ring.centre, ring.tangent, wall.outer,
                               scene.solid.anchors == SolidSettings::Anchors::breathing});
  });
  for (const WallPatch &patch : wall.patches)
    body.contacts.push_back(contact_on(scene, line, wall, patch));
  for (const LoadStep &step : scene.steps)
    body.steps.push_back(as_step_of_body(scene, step));
  Scene result = scene;
  result.continuum = body;
  result.continuum_settings.degree = scene.solid.degree;
  result.continuum_settings.linear_solver = ContinuumSettings::LinearSolver::direct; // thin cells
  return result;
}

std::vector<TiedSection> tied_sections(const Scene &scene, const Model &line,
                                       const PipeWall &wall) {
  std::vector<TiedSection> sections;
  for_each_restraint(scene, line, wall, [&](const WallRing &ring, const std::vector<Motion> &held) {
    if (held.size() < 6)
      sections.push_back({ring.centre, ring.tangent, wall.outer, held});
  });
  return sections;
}

void check_can_be_solid(const Scene &scene) {
  using LinearSolver = ContinuumSettings::LinearSolver;
  const LinearSolver wish = scene.continuum_settings.linear_solver;
  if (wish == LinearSolver::amg || wish == LinearSolver::multigrid)
    throw UserError("Walls of pipes are factored.\n  read:    Continuum/Linear solver = " +
                    std::string(wish == LinearSolver::amg ? "amg" : "multigrid") +
                    "\n  "
                    "allowed: auto or direct with Model = solid\n  try:     to leave it out");
  if (n_processes() > 1)
    throw UserError("Walls of pipes are solved by one process.\n  read:    solid pipes under "
                    "mpirun\n  allowed: one process\n  try:     without mpirun");
  if (scene.restraints.empty())
    throw UserError("Nothing holds the solid pipe.\n  read:    no anchor\n  allowed: anchors, and "
                    "supports beside them\n  try:     an anchor at one end");
}

void check_patches(const Scene &scene, const PipeWall &wall, const ContinuumBody<3> &body) {
  std::vector<unsigned int> n_nodes(wall.patches.size(), 0);
  for (const ContinuumContactNode<3> &node : body.nodes)
    ++n_nodes[node.surface];
  for (std::size_t p = 0; p < n_nodes.size(); ++p)
    if (n_nodes[p] == 0)
      throw UserError(
          "Support " + scene.supports[wall.patches[p].support].name +
          ": no node of the wall lies on its patch.\n  read:    " + std::to_string(wall.around) +
          " Cells around of degree " + std::to_string(scene.solid.degree) +
          "\n  allowed: nodes nearer than a patch's arc of 30 degrees\n  try:     "
          "Cells around = 16 in section Solid, or more");
}

double force_of_rounding(const Scene &body_scene, const PipeWall &wall) {
  constexpr double no_strain = 1e-9;
  return no_strain * body_scene.continuum->materials.front().youngs_modulus * wall.area();
}

double imbalance_of_supports(const Motion &load, const Results &results, const Frame &frame,
                             const PipeWall &wall, const ContinuumBody<3> &body,
                             const ContinuumState &state, const double rounding) {
  const Point3 &middle = wall.rings.front().centre;
  double size = wall.outer; // of the line
  for (const WallRing &ring : wall.rings)
    size = std::max(size, ring.centre.distance(middle));
  Vector3 forces, moments;
  double largest = rounding;
  const auto add = [&](const Vector3 &force, const Vector3 &moment) {
    forces += force;
    moments += moment;
    largest = std::max({largest, force.norm(), moment.norm() / size});
  };
  const auto halves = [](const Motion &both) {
    return std::pair(Vector3({both[0], both[1], both[2]}), Vector3({both[3], both[4], both[5]}));
  };
  add(halves(load).first, halves(load).second);
  for (unsigned int i = 0; i < frame.reactions.size(); ++i) {
    const auto [force, moment] = halves(frame.reactions[i]);
    add(force, moment + cross_product_3d(Vector3(results.restraints[i].position - middle), force));
  }
  std::vector<Vector3> of_patches(wall.patches.size());
  for (unsigned int i = 0; i < body.nodes.size(); ++i) {
    const ContinuumContactNode<3> &node = body.nodes[i];
    Vector3 force;
    for (unsigned int a = 0; a < 3; ++a)
      force += node.weight * state.contacts.stress[i][a] * node.frame[a];
    of_patches[node.surface] += cross_product_3d(Vector3(node.position - middle), force);
  }
  for (const SupportState &support : frame.supports)
    add(force_in_space(support), Vector3());
  for (const Vector3 &moment : of_patches)
    add(Vector3(), moment);
  return std::max(forces.norm(), moments.norm() / size) / largest;
}

} // namespace frictionbeam
