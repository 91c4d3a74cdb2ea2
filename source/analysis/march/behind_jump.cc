// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/march/behind_jump.h"

#include "analysis/increment/time_step.h"
#include "analysis/time/alpha_scheme.h"
#include "analysis/time/step_helpers.h"

#include <algorithm>

namespace frictionbeam {

namespace {

/// With impulses where the run's integrator has them.
AlphaScheme::Parameters parameters_of(const Scene &scene) {
  const Integrator by = scene.time.integrator;
  AlphaScheme::Parameters result; // those of the trapezoidal rule
  result.impulses =
      scene.solver.is_exact() || (by != Integrator::newmark && by != Integrator::generalized_alpha);
  return result;
}

/// Give a state the forces of contacts and the nodes without mass of an instant later, if they are
/// found.
void settle(const Model &model, const LoadCourse &course, const std::vector<bool> &has_mass,
            AlphaScheme &scheme, LineState &state) {
  constexpr double instant = 1e-3; // of a time step, and of the time to the next corner
  const double longest = time_step(model),
               until_corner = course.next_break(state.time + instant * longest) - state.time,
               step = instant * std::min(longest, until_corner);
  LineState impulses, after;
  if (!scheme.advance(state, course, state.time + step, impulses).result.converged ||
      !scheme.advance(impulses, course, impulses.time + step, after).result.converged)
    return;
  state.contact_stress = after.contact_stress;
  state.contact_status = after.contact_status;
  for (Eigen::Index i = 0; i < state.unknowns.size(); ++i)
    if (!has_mass[i])
      state.unknowns[i] = after.unknowns[i];
}

/// Make all degrees of freedom and the contacts' strains those of the unknowns and of what is
/// imposed behind the jump.
void place(const Model &model, const LoadCourse &course, LineState &state) {
  model.space.expand(state.unknowns, state.dofs);
  state.dofs += course.imposed(state.time, LoadCourse::Side::after);
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    state.contacts.strain[i] = model.contacts[i].strain(state.dofs);
    if (state.contact_status[i] == ContactStatus::open)
      state.contacts.touch[i] = state.contacts.strain[i];
  }
}

} // namespace

LineState state_behind_jump(const Model &model, const LoadCourse &course, const LineState &state) {
  const bool is_linear = model.cells.is_linear(); // the poses of others are no sums
  const std::vector<bool> has_mass = unknowns_with_mass(model.cells.mass());
  const bool any_massless = std::count(has_mass.begin(), has_mass.end(), false) > 0;
  AlphaScheme scheme(model, parameters_of(model.scene));
  LineState result = state;
  result.events.clear(); // they have been shown
  scheme.start(result, course);
  if (model.contacts.size() > 0 || (is_linear && any_massless))
    settle(model, course, has_mass, scheme, result);
  if (is_linear)
    place(model, course, result);
  scheme.start(result, course);
  return result;
}

} // namespace frictionbeam
