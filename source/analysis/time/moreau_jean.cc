// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/moreau_jean.h"
#include "analysis/time/step_helpers.h"

#include "analysis/time/stiff_friction.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

MoreauJean::MoreauJean(const Model &model)
    : model(model), theta(model.scene.time.theta), contacts(model), stiff(model.linear.stiffness()),
      momentum(model.linear.mass()), stiffness_diagonal(model.linear.stiffness().diagonal()) {
  const std::vector<bool> has_mass = unknowns_with_mass(model.linear.mass());
  for (unsigned int i = 0; i < has_mass.size(); ++i)
    if (!has_mass[i])
      massless.push_back(i);
}

void MoreauJean::start(LineState &state, const LoadCourse &) {
  state.acceleration = state.auxiliary = Vector::Zero(state.unknowns.size());
  last_time = std::numeric_limits<double>::quiet_NaN();
}

void MoreauJean::set_step(const double h) {
  if (std::abs(h - effective_step) <= same_instant_of_step * h)
    return;
  effective = model.linear.stiffness() + 1. / (h * h * theta * theta) * model.linear.mass();
  if (model.linear.damping().nonZeros() > 0)
    effective = effective + 1. / (h * theta) * model.linear.damping();
  effective_step = h;
  contacts.set_matrix(effective);
}

std::string MoreauJean::warning() const {
  return warn_of_stiff_friction(model, model.scene.time.row().word, false);
}

void MoreauJean::transfer(Archive &archive) {
  double step = effective_step;
  archive(step);
  if (archive.reads() && step > 0.)
    set_step(step);
  contacts.transfer(archive);
}

TimeStep MoreauJean::advance(const LineState &from, const LoadCourse &loads, const double time,
                             LineState &to) {
  const double h = time - from.time, part = (1. - theta) / theta;
  const SparseMatrix &C = model.linear.damping();
  const bool damped = C.nonZeros() > 0;
  set_step(h);
  if (const LoadCourse::Factors factors = loads.factors_after(from.time);
      last_time != from.time || factors != last_factors) {
    last_factors = factors;
    last_forces = loads.forces(factors);
    loads.add_inertia(from.time, last_forces, LoadCourse::Side::after);
  }
  const Vector forces_before = last_forces;
  last_factors = loads.factors_before(time);
  last_forces = loads.forces(last_factors);
  loads.add_inertia(time, last_forces, LoadCourse::Side::before);
  last_time = time;
  const Vector &forces = last_forces;
  const Vector &q0 = from.unknowns, &v0 = from.velocity;
  const Vector stiff_before = stiff(q0), momentum_before = momentum(v0);
  // The equation of motion divided by theta h.
  const Vector known =
      forces + part * (forces_before - stiff_before - contacts.elastic_forces(from));
  Vector velocity_after;
  const double size = size_of_forces(std::max(largest(known), largest(stiff_before)),
                                     largest(stiffness_diagonal.cwiseProduct(q0)) +
                                         largest(momentum_before) / (h * theta * theta),
                                     model.scene.solver.tolerance);
  EquilibriumProblem problem{effective, Vector::Constant(1, size), loads.imposed(time)};
  problem.unbalanced = [&](const Vector &unknowns, const Vector &low) -> Vector {
    if (unknowns == q0 && low.isZero(0.)) {
      velocity_after = (1. - 1. / theta) * v0;
      for (const int i : massless)
        velocity_after[i] = 0.;
      return known - stiff_before + momentum_before / (h * theta * theta);
    }
    Vector motion = unknowns - q0;
    if (low.size() > 0)
      motion += low;
    velocity_after = (1. - 1. / theta) * v0 + motion / (h * theta);
    for (const int i : massless)
      velocity_after[i] = motion[i] / h;
    Vector left =
        known - stiff(unknowns) - (momentum(velocity_after) - momentum_before) / (h * theta);
    if (damped)
      left -= C * motion / (h * theta);
    return left;
  };
  problem.increment = {time, h, model.contacts.temperatures(last_factors)};

  TimeStep step;
  ContactResponse response;
  to.unknowns = q0;
  take_over_contacts(from, to);
  step.result = contacts.solve(problem, from, loads.imposed(from.time),
                               {from.unknowns + h * (1. - theta) * from.velocity, h * theta, theta,
                                loads.may_jump(from.time, time)},
                               to.unknowns, response);
  if (!step.result.converged)
    return step;

  to.velocity = velocity_after;
  to.acceleration = (to.velocity - from.velocity) / h;
  to.auxiliary = to.acceleration;
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += problem.imposed;
  to.time = time;
  to.load_factors = last_factors;
  loads.set_rates(to, LoadCourse::Side::before);
  commit_contacts(response, from, to);
  contacts.add_histories(from, h, to);
  step.energy = account_motion(
      model, from, to, {stiff_before, stiff(to.unknowns), momentum_before, momentum(to.velocity)},
      forces_before, forces, contacts.work());
  if (q0.size() > 0)
    step.error = h * h / 12. * (to.auxiliary - from.auxiliary).lpNorm<Eigen::Infinity>();
  return step;
}

} // namespace frictionbeam
