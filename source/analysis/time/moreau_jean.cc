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

const Vector &MoreauJean::forces_after(const LoadCourse &loads, const double time) {
  const LoadCourse::Factors factors = loads.factors_after(time);
  if (last_time != time || factors != last_factors) {
    last_factors = factors;
    last_forces = loads.forces(factors);
    loads.add_inertia(time, last_forces, LoadCourse::Side::after);
  }
  return last_forces;
}

MoreauJean::Step MoreauJean::begin(const LineState &from, const LoadCourse &loads,
                                   const double time) {
  Step step;
  step.h = time - from.time;
  step.forces_before = forces_after(loads, from.time);
  last_factors = loads.factors_before(time);
  last_forces = loads.forces(last_factors);
  loads.add_inertia(time, last_forces, LoadCourse::Side::before);
  last_time = time;
  step.forces = last_forces;
  step.stiff_before = stiff(from.unknowns);
  step.momentum_before = momentum(from.velocity);
  const double part = (1. - theta) / theta;
  step.known = step.forces + part * (step.forces_before - step.stiff_before);
  contacts.take_elastic_forces(from, part, step.known);
  return step;
}

double MoreauJean::size_of(const Step &step, const LineState &from) const {
  return size_of_forces(std::max(largest(step.known), largest(step.stiff_before)),
                        largest(stiffness_diagonal.cwiseProduct(from.unknowns)) +
                            largest(step.momentum_before) / (step.h * theta * theta),
                        model.scene.solver.tolerance);
}

Vector MoreauJean::unbalanced(Step &step, const LineState &from, const Vector &unknowns,
                              const Vector &low) {
  const double h = step.h;
  step.velocity_after = (1. - 1. / theta) * from.velocity;
  if (unknowns == from.unknowns && low.isZero(0.)) { // the first guess, without a product
    for (const int i : massless)
      step.velocity_after[i] = 0.;
    return step.known - step.stiff_before + step.momentum_before / (h * theta * theta);
  }
  Vector motion = unknowns - from.unknowns;
  if (low.size() > 0)
    motion += low;
  step.velocity_after += motion / (h * theta);
  for (const int i : massless)
    step.velocity_after[i] = motion[i] / h;
  Vector left = step.known - stiff(unknowns) -
                (momentum(step.velocity_after) - step.momentum_before) / (h * theta);
  if (const SparseMatrix &C = model.linear.damping(); C.nonZeros() > 0)
    left -= C * motion / (h * theta);
  return left;
}

TimeStep MoreauJean::advance(const LineState &from, const LoadCourse &loads, const double time,
                             LineState &to) {
  set_step(time - from.time);
  Step step = begin(from, loads, time);
  EquilibriumProblem problem{{effective, Vector::Constant(1, size_of(step, from))},
                             loads.imposed(time)};
  problem.unbalanced = [&](const Vector &unknowns, const Vector &low) {
    return unbalanced(step, from, unknowns, low);
  };
  problem.end = time;
  problem.increment = {loads.time_of_laws(time), step.h, model.contacts.temperatures(last_factors)};

  TimeStep report;
  ContactResponse response;
  to.unknowns = from.unknowns;
  take_over_contacts(from, to);
  report.result = contacts.solve(
      problem, from, loads,
      {from.unknowns + step.h * (1. - theta) * from.velocity, step.h * theta, theta, theta},
      to.unknowns, response);
  if (!report.result.converged)
    return report;

  arrive(model, loads, time, last_factors, problem.imposed, to);
  to.velocity.swap(step.velocity_after);
  to.acceleration = (to.velocity - from.velocity) / step.h;
  to.auxiliary = to.acceleration;
  commit_contacts(response, from.contact_status, to);
  contacts.add_histories(from, step.h, to);
  report.energy = account_motion(
      model, from, to,
      {step.stiff_before, stiff(to.unknowns), step.momentum_before, momentum(to.velocity)},
      step.forces_before, step.forces, contacts.work());
  report.energy += contacts.work_beyond_motion();
  if (from.unknowns.size() > 0)
    report.error =
        step.h * step.h / 12. * (to.auxiliary - from.auxiliary).lpNorm<Eigen::Infinity>();
  return report;
}

} // namespace frictionbeam
