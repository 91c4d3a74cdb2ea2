// SPDX-License-Identifier: LGPL-2.1-or-later
#include "moreau_jean.h"

#include <cmath>

namespace frictionbeam {

MoreauJean::MoreauJean(const Model &model)
    : model(model), theta(model.scene.time.theta),
      has_mass(unknowns_with_mass(model.linear.mass())), contacts(model) {}

void MoreauJean::start(LineState &state, const LoadCourse &) {
  state.acceleration = state.auxiliary = Vector::Zero(state.unknowns.size());
}

void MoreauJean::set_step(const double h) {
  if (std::abs(h - effective_step) <= 1e-9 * h)
    return;
  effective = model.linear.stiffness() + 1. / (h * h * theta * theta) * model.linear.mass();
  if (model.linear.damping().nonZeros() > 0)
    effective = effective + 1. / (h * theta) * model.linear.damping();
  effective_step = h;
  contacts.set_matrix(effective);
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
  const SparseMatrix &M = model.linear.mass(), &C = model.linear.damping();
  const bool damped = C.nonZeros() > 0;
  set_step(h);
  const Vector forces_before = loads.forces_after(from.time), forces = loads.forces_before(time);
  // The equation of motion divided by theta h, in q1.
  EquilibriumProblem problem{effective, forces + part * forces_before, loads.imposed(time)};
  problem.right_hand_side +=
      M * (from.unknowns / h + from.velocity) / (h * theta * theta) -
      part * (model.linear.stiffness() * from.unknowns + contacts.elastic_forces(from));
  if (damped)
    problem.right_hand_side += C * from.unknowns / (h * theta);
  problem.time = time;
  problem.time_increment = h;

  TimeStep step;
  ContactResponse response;
  to = from;
  step.result = contacts.solve(problem, from, loads.imposed(from.time),
                               {from.unknowns + h * (1. - theta) * from.velocity, h * theta, theta},
                               to.unknowns, response);
  if (!step.result.converged)
    return step;

  const Vector mean = (to.unknowns - from.unknowns) / h;
  to.velocity = from.velocity + (mean - from.velocity) / theta;
  for (int i = 0; i < mean.size(); ++i)
    if (!has_mass[i])
      to.velocity[i] = mean[i];
  to.acceleration = (to.velocity - from.velocity) / h;
  to.auxiliary = to.acceleration;
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += problem.imposed;
  to.time = time;
  to.load_factors = loads.factors(time);
  commit_contacts(response, from, to);
  contacts.add_histories(from, h, to);
  step.energy = account_motion(model, from, to, forces_before, forces, contacts.work());
  if (mean.size() > 0)
    step.error = h * h / 12. * (to.auxiliary - from.auxiliary).lpNorm<Eigen::Infinity>();
  return step;
}

} // namespace frictionbeam
