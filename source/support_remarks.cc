// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support_remarks.h"

#include <frictionbeam/model/finite_rigidity.h>
#include <frictionbeam/model/ground_point.h>
#include <frictionbeam/results/text.h>
#include <frictionbeam/scene/user_error.h>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

namespace {

std::string length_text(const Scene &scene, const double length) {
  return rounded_number(length / scene.units.factor("m"), 3) + " " + scene.units.name("m");
}

/// Whether some step was solved by return mapping, which needs a stiffness.
bool maps_back(const Scene &scene) {
  using Integrator = TimeSettings::Integrator;
  const bool transient = std::any_of(scene.steps.begin(), scene.steps.end(),
                                     [](const LoadStep &step) { return step.transient; });
  return scene.solver.method != SolverSettings::Method::exact ||
         (transient && (scene.time.integrator == Integrator::newmark ||
                        scene.time.integrator == Integrator::generalized_alpha));
}

void add_effect_of_rigidity(const Model &model, Results &results) {
  constexpr double worth_a_remark = 1e-6;
  double deepest = 0., force = 0.;
  std::string where;
  for (const Frame &frame : results.frames)
    for (unsigned int i = 0; i < model.contacts.size() && i < frame.supports.size(); ++i) {
      const Contact &contact = model.contacts[i];
      const SupportState &state = frame.supports[i];
      if (is_rigid(model.scene.supports[contact.support], *contact.law) &&
          contact.platen_force == 0. && -state.gap > deepest && state.fn > 0.) {
        deepest = -state.gap;
        force = state.fn;
        where = results.supports[i].name;
      }
    }
  double moved = 0.;
  for (const StepReport &step : results.steps)
    moved = std::max(moved, step.resolution.largest_displacement);
  if (deepest <= worth_a_remark * moved || deepest == 0.)
    return;
  const Scene &scene = model.scene;
  results.remarks.push_back(
      "Rigid supports are not rigid here: return mapping needs a stiffness, and took " +
      rounded_number(force / deepest / scene.units.factor("N/m"), 3) + " " +
      scene.units.name("N/m") + " for " + where + ", which gives by " +
      length_text(scene, deepest) + ", " + rounded_number(100. * deepest / moved, 2) +
      " % of the largest displacement. Solver/Method = exact and the integrators moreau_jean and "
      "event need none; or give the support an Axial rigidity.");
}

void add_torn_off(Results &results) {
  constexpr std::size_t most_named = 5;
  for (const StepReport &step : results.steps) {
    if (step.torn_off.empty())
      continue;
    std::string names;
    for (std::size_t n = 0; n < std::min(most_named, step.torn_off.size()); ++n)
      names += (n == 0 ? "" : ", ") + results.supports[step.torn_off[n]].name;
    if (step.torn_off.size() > most_named)
      names += " and " + std::to_string(step.torn_off.size() - most_named) + " more";
    results.remarks.push_back(
        "Step " + step.step + ": within one increment, " + names +
        " went from sticking to open. What sticks has to slip before it lifts off: the increment "
        "is too long to show it, or the line has jumped to another equilibrium. Take more "
        "Increments, or a slow transient step.");
  }
}

} // namespace

void add_remarks_on_model(const Model &model, Results &results) {
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    const FrictionSupport &support = model.scene.supports[contact.support];
    const Vector3 arm =
        support.ground.empty() ? Vector3() : arm_of_ground(model.discretization, contact);
    if (arm.norm() == 0. || contact.site > 0)
      continue;
    const bool turns = model.discretization.vertex_dofs().index(contact.vertices[1], 3) !=
                       numbers::invalid_dof_index;
    if (model.corotational && turns)
      throw UserError("Support " + support.name + " stands beside its Ground " + support.ground +
                      ", seen along its normal, and large displacements do not know how that "
                      "point's pipe would turn under it. Leave Normal out, or place the point on "
                      "the normal.");
    results.remarks.push_back(
        "Support " + support.name + " stands " + length_text(model.scene, arm.norm()) +
        " beside its Ground " + support.ground + ", seen along its normal. " +
        (turns ? "The pipe there reaches under it by a rigid arm, and takes its moment."
               : "That point has no rotations: the moment of the support's force about it is "
                 "carried by nothing that is modelled."));
  }
}

void add_remarks_on_supports(const Model &model, Results &results) {
  if (maps_back(model.scene))
    add_effect_of_rigidity(model, results);
  add_torn_off(results);
}

} // namespace frictionbeam
