// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/slope_search.h"
#include "analysis/time/alpha_scheme.h"
#include "analysis/time/mass_factorization.h"
#include "analysis/time/step_helpers.h"
#include "base/interruption.h"

#include <algorithm>
#include <limits>

namespace frictionbeam {

void AlphaScheme::prepare_turning() {
  const SparseMatrix &M = model.cells.mass();
  if (model.scene.time.mass_damping != 0.)
    mass_damping = model.scene.time.mass_damping * M;
  Vector with_mass = M.diagonal();
  set_rotations(model, Vector::Ones(model.space.n_dofs()), with_mass);
  for (unsigned int i = 0; i < has_mass.size(); ++i)
    has_mass[i] = with_mass[i] > 0.;
  for (unsigned int l = 0; l < imposed_inertia.size(); ++l)
    if (model.linear.accelerates(l))
      imposed_inertia[l] = model.cells.inertia(l);
}

const SparseMatrix &AlphaScheme::mass_matrix() const {
  return turns ? model.cells.mass() : model.linear.mass();
}

void AlphaScheme::add_inertia(const LoadCourse &loads, const double time,
                              const LoadCourse::Side side, Vector &forces) const {
  if (!turns)
    return loads.add_inertia(time, forces, side);
  LineState there;
  there.time = time;
  loads.set_rates(there, side);
  for (unsigned int l = 0; l < there.load_rates.size(); ++l)
    if (model.linear.accelerates(l))
      forces +=
          (there.load_accelerations[l] + model.scene.time.mass_damping * there.load_rates[l]) *
          imposed_inertia[l];
}

Vector AlphaScheme::accelerations(Vector forces, const Pose &pose) {
  for (int i = 0; i < forces.size(); ++i)
    if (!has_mass[i]) // a platen, a node without mass: moves with its forces balanced
      forces[i] = 0.;
  if (turns) {
    keep_inert(pose, Vector::Zero(forces.size()), forces);
    SparseMatrix matrix = model.cells.mass();
    model.cells.add_rotary_mass(pose, matrix);
    factor_mass(matrix, mass);
  }
  return mass.solve(forces);
}

void AlphaScheme::keep_inert(const Pose &pose, const Vector &mean, Vector &rates) const {
  Vector of_mean, of_rates;
  model.space.expand(mean, of_mean);
  model.space.expand(rates, of_rates);
  model.cells.keep_inert(pose, of_mean, of_rates);
  set_rotations(model, of_rates, rates);
}

Vector AlphaScheme::forces_at(const LineState &state, const LoadCourse::Factors &factors) const {
  const Pose pose = pose_of(state);
  LineCells::Balance balance;
  model.cells.evaluate({pose, pose, pose, pose.dofs, 0., {}, nullptr, &pose, true}, factors,
                       balance);
  Vector forces = balance.forces + model.contacts.platen_forces();
  const Vector spin = model.cells.velocities(state.velocity, {}),
               none = Vector::Zero(model.space.n_dofs());
  model.cells.add_rotary_at(pose, {spin, none, none, 0., 0., model.scene.time.mass_damping}, forces,
                            nullptr);
  return forces;
}

void AlphaScheme::evaluate(const LoadCourse &loads, const Vector &unknowns, const double time,
                           Step &step) const {
  const SparseMatrix &M = mass_matrix(), &C = damping();
  const double h = step.h;
  Vector turned;
  if (turns) {
    model.space.expand(unknowns - step.begin, turned);
    step.pose = model.cells.moved(step.start, turned + step.imposed);
  } else {
    model.space.expand(unknowns, step.pose.dofs);
    step.pose.dofs += loads.imposed(time);
  }
  step.moved = (unknowns - step.motion) / (p.beta * h * h);
  LineCells::Step of_cells{step.pose,      step.pose,  step.pose,
                           step.pose.dofs, 0.,         {loads.time_of_laws(time), h},
                           nullptr,        &step.start};
  of_cells.is_near_last = step.is_answered;
  model.cells.evaluate(of_cells, step.factors, step.balance);
  step.is_answered = !step.balance.failure;
  const Vector acceleration = ratio * step.moved + step.rest,
               velocity = step.velocity + p.gamma * h * step.moved;
  Vector inertia = -(M * acceleration);
  add_inertia(loads, time, LoadCourse::Side::before, inertia);
  step.residual = step.balance.forces + model.contacts.platen_forces() + inertia;
  step.matrix = step.balance.stiffness + ratio / (p.beta * h * h) * M;
  if (C.nonZeros() > 0) {
    step.residual -= C * velocity;
    step.matrix = step.matrix + p.gamma / (p.beta * h) * C;
  }
  if (turns) {
    const Vector spin = model.cells.velocities(velocity, {}),
                 change_of_spin = model.cells.velocities(acceleration, {});
    model.cells.add_rotary_at(step.pose,
                              {spin, change_of_spin, turned, p.gamma / (p.beta * h),
                               ratio / (p.beta * h * h), model.scene.time.mass_damping},
                              step.residual, &step.matrix);
  }
  step.largest = std::max(step.balance.largest, largest(inertia));
}

EquilibriumResult AlphaScheme::solve_linearized(const Step &step, const LineState &from,
                                                const LoadCourse &loads, const double time,
                                                const Vector &unknowns, Vector &change,
                                                ContactResponse &response) {
  const bool is_free = turns && model.contacts.size() == 0; // by the matrix itself
  const SparseMatrix symmetric = is_free ? SparseMatrix() : symmetric_part(step.matrix);
  EquilibriumProblem problem{{is_free ? step.matrix : symmetric, step.residual}, step.pose.dofs};
  problem.end = time;
  problem.increment = {loads.time_of_laws(time), step.h, model.contacts.temperatures(step.factors)};
  problem.largest_force = step.largest;
  problem.force_so_far =
      std::max(step.balance.free, largest(step.momentum_before) * ratio / (p.beta * step.h));
  if (!p.impulses || is_free)
    return linearized.solve(problem, from.contacts, change, response);
  const double reach = step.h * p.beta / p.gamma;
  contacts.set_matrix(symmetric);
  change.setZero(unknowns.size());
  EquilibriumResult result = contacts.solve(
      problem, from, loads,
      {step.motion - reach * step.velocity - unknowns, reach, p.gamma / ratio}, change, response);
  result.no_equilibrium = false;
  return result;
}

Vector AlphaScheme::left_over(const Step &step, const ContactResponse &response) const {
  Vector left = step.residual, of_contacts = Vector::Zero(left.size());
  model.contacts.add_forces(response, of_contacts);
  left -= of_contacts;
  if (p.impulses) // of which the response has the mean over the step
    left += (ratio / p.gamma - 1.) / step.h * contacts.impulses();
  return left;
}

bool AlphaScheme::is_solved(const Step &step, const double time_of_laws,
                            const ContactResponse &response, EquilibriumResult &result) const {
  const double size = largest(left_over(step, response)),
               force = std::max(step.largest, largest_contact_force(model.contacts, response)),
               scale = std::max({force, step.balance.free,
                                 largest(step.momentum_before) * ratio / (p.beta * step.h)});
  result.residual = scale > 0. ? size / scale : size;
  const auto rounding = [&]() {
    const Pose beside = with_other_digits(model, step.pose, true);
    LineCells::Balance there;
    model.cells.evaluate(
        {beside, beside, beside, beside.dofs, 0., {time_of_laws, step.h}, nullptr, &step.start},
        step.factors, there);
    return largest(there.forces - step.balance.forces);
  };
  return is_balanced(model, largest_diagonal(step.matrix), size, force, step.pose, rounding, scale);
}

void AlphaScheme::add_change(const Vector &change, const Step &step, Vector &unknowns) const {
  unknowns += change;
  if (!turns)
    return;
  Vector on_dofs;
  model.space.expand(change, on_dofs);
  set_rotations(model, model.cells.change(step.start, model.cells.moved(step.pose, on_dofs)),
                unknowns);
}

EquilibriumResult AlphaScheme::solve_nonlinear(Step &step, const LineState &from,
                                               const LoadCourse &loads, const double time,
                                               LineState &to, ContactResponse &response) {
  EquilibriumResult result;
  Vector change;
  step.start = step.pose = pose_of(from);
  to.unknowns = step.motion + p.beta * step.h * step.h * from.auxiliary;
  evaluate(loads, to.unknowns, time, step);
  bool judged = false; // whether the contacts' forces are those at the pose
  for (;;) {
    interruption::end_if_overdue();
    if (step.balance.failure || !step.residual.allFinite()) {
      result.remark = step.balance.failure ? step.balance.failure : "the iteration diverges";
      return result;
    }
    if (judged && is_solved(step, loads.time_of_laws(time), response, result)) {
      result.converged = true;
      to.sections = step.balance.sections;
      return result;
    }
    // As in NonlinearMotion: what a line that turns makes of the contacts' forces is left to its
    // own matrix, for theirs is taken symmetric.
    if (judged && turns && model.contacts.size() > 0 &&
        linearized.solve_without_contacts(step.matrix, left_over(step, response), change)) {
      ++result.factorizations;
      add_change(change, step, to.unknowns);
      evaluate(loads, to.unknowns, time, step);
      if (step.balance.failure || !step.residual.allFinite())
        continue;
    }
    const auto solve_here = [&]() {
      return solve_linearized(step, from, loads, time, to.unknowns, change, response);
    };
    if (!iterate(model.scene.solver.max_iterations, solve_here, result))
      return result;
    if (turns) {
      add_change(change, step, to.unknowns);
      evaluate(loads, to.unknowns, time, step);
      judged = true;
      continue;
    }
    const Vector unknowns = to.unknowns;
    const auto slope_at = [&](const double length) {
      to.unknowns = unknowns + length * change;
      evaluate(loads, to.unknowns, time, step);
      return step.balance.failure ? std::numeric_limits<double>::max()
                                  : -left_over(step, response).dot(change);
    };
    if (result.iterations > 1)
      judged = search_slope(-left_over(step, response).dot(change), slope_at) == 1. ||
               model.contacts.size() == 0;
    else {
      slope_at(1.);
      judged = true;
    }
  }
}

EnergyAccount AlphaScheme::account_turning(const Step &step, const LineState &from,
                                           const LoadCourse &loads, const LineState &to) const {
  const LineCells &line = model.cells;
  EnergyAccount account =
      account_cells(model, from, to, loads.factors_after(from.time), step.imposed);
  const double lost = model.scene.time.mass_damping * step.h / 2.; // part of the momentum
  const Pose start = pose_of(from), end = pose_of(to);
  const Vector velocity_before = line.velocities(from.velocity, from.load_rates),
               velocity = line.velocities(to.velocity, to.load_rates),
               before = line.momenta(start, velocity_before), after = line.momenta(end, velocity),
               none = Vector::Zero(to.velocity.size()),
               of_imposed =
                   (line.velocities(none, from.load_rates) + line.velocities(none, to.load_rates)) /
                   2.,
               mean = (line.change(start, end) - step.imposed) / step.h + of_imposed;
  const double kinetic = velocity.dot(after) / 2.;
  account.kinetic = kinetic - velocity_before.dot(before) / 2.;
  account.damping = lost * mean.dot(before + after);
  account.external += of_imposed.dot((1. + lost) * after - (1. - lost) * before);
  account.at_hand = kinetic + std::abs(line.stored_energy(end));
  account.turnover += std::abs(account.kinetic);
  return account;
}

EnergyAccount AlphaScheme::account_nonlinear(const Step &step, const LineState &from,
                                             const LoadCourse &loads, const LineState &to) const {
  if (turns)
    return account_turning(step, from, loads, to);
  const Vector motion = to.unknowns - from.unknowns;
  EnergyAccount account = account_cells(model, from, to, loads.factors_after(from.time),
                                        loads.imposed(to.time) - loads.imposed(from.time));
  Vector inertia = Vector::Zero(motion.size());
  loads.add_inertia(from.time, inertia, LoadCourse::Side::after);
  loads.add_inertia(to.time, inertia, LoadCourse::Side::before);
  account.external += inertia.dot(motion) / 2.;
  const double kinetic = to.velocity.dot(model.linear.mass() * to.velocity) / 2.;
  account.kinetic = kinetic - from.velocity.dot(step.momentum_before) / 2.;
  if (model.linear.damping().nonZeros() > 0)
    account.damping = (from.velocity + to.velocity).dot(model.linear.damping() * motion) / 2.;
  account.at_hand = kinetic + std::abs(model.cells.stored_energy(pose_of(to))) +
                    model.linear.kinetic_by_imposed(to.load_rates, to.velocity);
  account.turnover += std::abs(account.kinetic);
  EnergyAccount imposed = account_imposed(model, from, to, step.h);
  imposed.external -= imposed.stored; // which the cells' account has
  imposed.stored = 0.;
  return account += imposed;
}

} // namespace frictionbeam
