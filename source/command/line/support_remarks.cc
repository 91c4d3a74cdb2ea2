// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/line/support_remarks.h"

#include "base/user_error.h"
#include "model/cell/line_cells.h"
#include "model/contact/finite_rigidity.h"
#include "model/contact/ground_point.h"
#include "results/text.h"

#include <algorithm>
#include <map>
#include <set>

namespace frictionbeam {

using namespace dealii;

namespace {

std::string length_text(const Scene &scene, const double length) {
  return rounded_number(length / scene.units.factor("m"), 3) + " " + scene.units.name("m");
}

/// By the scene's parameters: the model may have others (make_rigid_contacts_finite()).
bool is_rigid_in_scene(const Scene &scene, const Contact &contact) {
  return BoundLaw(contact.law.description(), scene.supports[contact.support].parameters)
      .is_rigid_along_normal();
}

void add_effect_of_rigidity(const Model &model, Results &results) {
  constexpr double worth_a_remark = 1e-6;
  double deepest = 0., force = 0.;
  std::string where;
  for (const Frame &frame : results.frames)
    for (unsigned int i = 0; i < frame.supports.size(); ++i) {
      const Contact &contact = model.contacts[model.contacts.places()[i].front()];
      const SupportState &state = frame.supports[i];
      if (is_rigid_in_scene(model.scene, contact) && contact.platen_force == 0. &&
          -state.gap > deepest && state.fn > 0.) {
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
      length_text(scene, deepest) +
      (moved > 0.
           ? ", " + rounded_number(100. * deepest / moved, 2) + " % of the largest displacement"
           : std::string()) +
      ". Solver/Method = exact needs none; or give the support an Axial rigidity.");
}

const std::string &name_of(const unsigned int contact, const Results &results) {
  return results.supports[results.support_of[contact]].name;
}

/// Names of contacts, the first of them.
template <typename Indices>
std::string names_of(const Indices &contacts, const Results &results) {
  std::vector<std::string> names;
  for (const unsigned int contact : contacts)
    if (names.empty() || names.back() != name_of(contact, results)) // both edges of one
      names.push_back(name_of(contact, results));
  return first_of(names);
}

void add_torn_off(Results &results) {
  for (const StepReport &step : results.steps)
    if (!step.torn_off.empty())
      results.remarks.push_back(
          "Step " + step.step + ": within one increment, " + names_of(step.torn_off, results) +
          " went from sticking to open. What sticks has to slip before it lifts off: the increment "
          "is too long to show it, or the line has jumped to another equilibrium. Take more "
          "Increments, or a slow transient step.");
}

/// Steps of which something is said, "a, b".
template <typename IsMeant>
std::string steps_where(const Results &results, const IsMeant &is_meant) {
  std::string steps;
  for (const StepReport &step : results.steps)
    if (is_meant(step))
      steps += (steps.empty() ? "" : ", ") + step.step;
  return steps;
}

/// Which supports' states may not be the only ones, in a sentence; empty if none is known.
std::string several_equilibria(const Results &results) {
  std::map<unsigned int, contact::BeyondUniqueness> worst;
  for (const StepReport &step : results.steps)
    for (const contact::BeyondUniqueness &beyond : step.several_equilibria)
      if (const auto [entry, is_new] = worst.try_emplace(beyond.contact, beyond);
          !is_new && beyond.limit < entry->second.limit)
        entry->second = beyond;
  if (worst.empty())
    return "";
  std::vector<std::string> supports;
  for (const auto &[contact, beyond] : worst)
    supports.push_back(name_of(contact, results) + " (f = " + rounded_number(beyond.friction, 3) +
                       ", limit " + rounded_number(beyond.limit, 3) + ")");
  return "Several equilibria are possible at the end of " +
         steps_where(results,
                     [](const StepReport &step) { return !step.several_equilibria.empty(); }) +
         ", since friction exceeds the limit K_tt/|K_tn| up to which a support's state is "
         "unique: " +
         first_of(supports) + ". The answer is the one reached along the declared load sequence.";
}

/// Which rigid supports hold one motion together; empty if none do.
std::string undetermined_forces(const Results &results) {
  std::set<unsigned int> contacts;
  for (const StepReport &step : results.steps)
    contacts.insert(step.undetermined_forces.begin(), step.undetermined_forces.end());
  if (contacts.empty())
    return "";
  const auto have_them = [&](const bool within) {
    return steps_where(results, [within](const StepReport &step) {
      return !step.undetermined_forces.empty() && step.undetermined_within == within;
    });
  };
  const std::string at_ends = have_them(false), within = have_them(true);
  return "Nothing determines how these rigid supports share their forces" +
         (at_ends.empty() ? "" : " at the end of " + at_ends) +
         (within.empty() ? "" : (at_ends.empty() ? " within " : " and within ") + within) +
         ", for they hold the same motion: " + names_of(contacts, results) +
         ". Their sum is right, and all displacements where none of them slides; each share is one "
         "of many, and what slides goes as far as its share lets it. An Axial and a Shear rigidity "
         "determine them.";
}

/// Which rigid supports were struck, and what that means for their forces; empty if none was.
std::string struck_supports(const Model &model, const Results &results) {
  std::set<unsigned int> struck;
  for (const StepReport &step : results.steps)
    struck.insert(step.struck.begin(), step.struck.end());
  if (struck.empty())
    return "";
  return "Rigid supports were struck: " + names_of(struck, results) +
         ". The force of such an impact is infinite for no time, so that it has no largest value "
         "and tables of forces at instants miss it: its impulse is the answer, or give the "
         "support an Axial rigidity." +
         (model.scene.time.is_exact()
              ? ""
              : " Anchors, restraints and nozzles that such an impact reaches have it in their "
                "forces over a time step, which grow as the step shrinks.");
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
    const unsigned int on = contact.vertices[1];
    const bool turns = model.discretization.turns(on, 0) || model.discretization.turns(on, 1) ||
                       model.discretization.turns(on, 2);
    if (model.cells.turns_far() && turns)
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
  if (!model.scene.solver.is_exact())
    add_effect_of_rigidity(model, results);
  add_torn_off(results);
  for (const std::string &remark :
       {struck_supports(model, results), several_equilibria(results), undetermined_forces(results)})
    if (!remark.empty())
      results.remarks.push_back(remark);
}

void remark_on_laws(const Model &model, Results &results) {
  std::map<std::string, std::string> without_threshold;
  for (unsigned int i = 0; i < model.contacts.size(); ++i)
    if (const BoundLaw &law = model.contacts[i].law; !law.has_closed_form())
      without_threshold[law.name()] = law.closed_form_varies()
                                          ? " has a threshold that varies with more than its "
                                            "parameters: the exact method does not follow that, and"
                                          : " has no threshold in closed form: the exact method";
  if (model.scene.solver.is_exact())
    for (const auto &[law, what] : without_threshold)
      results.remarks.push_back("The law '" + law + "'" + what +
                                " evaluates it as it is, by Newton's method.");
}

} // namespace frictionbeam
