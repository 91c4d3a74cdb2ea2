// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/slope_search.h"
#include "analysis/time/alpha_scheme.h"
#include "analysis/time/step_helpers.h"
#include "base/interruption.h"

#include <algorithm>
#include <limits>

namespace frictionbeam {

Vector AlphaScheme::forces_at(const LineState &state, const LoadCourse::Factors &factors) const {
  const Pose pose = pose_of(state);
  LineCells::Balance balance;
  model.cells.evaluate({pose, pose, pose, pose.dofs, 0., {}, nullptr, &pose, true}, factors,
                       balance);
  return balance.forces + model.contacts.platen_forces();
}

void AlphaScheme::evaluate(const LoadCourse &loads, const Vector &unknowns, const double time,
                           Step &step) const {
  const SparseMatrix &M = model.linear.mass(), &C = model.linear.damping();
  const double h = step.h;
  model.space.expand(unknowns, step.pose.dofs);
  step.pose.dofs += loads.imposed(time);
  step.moved = (unknowns - step.motion) / (p.beta * h * h);
  model.cells.evaluate({step.pose,
                        step.pose,
                        step.pose,
                        step.pose.dofs,
                        0.,
                        {loads.time_of_laws(time), h},
                        nullptr,
                        &step.start},
                       step.factors, step.balance);
  Vector inertia = -(M * Vector(ratio * step.moved + step.rest));
  loads.add_inertia(time, inertia, LoadCourse::Side::before);
  step.residual = step.balance.forces + model.contacts.platen_forces() + inertia;
  step.matrix = step.balance.stiffness + ratio / (p.beta * h * h) * M;
  if (C.nonZeros() > 0) {
    step.residual -= C * Vector(step.velocity + p.gamma * h * step.moved);
    step.matrix = step.matrix + p.gamma / (p.beta * h) * C;
  }
  step.largest = std::max(step.balance.largest, largest(inertia));
}

EquilibriumResult AlphaScheme::solve_linearized(const Step &step, const LineState &from,
                                                const LoadCourse &loads, const double time,
                                                const Vector &unknowns, Vector &change,
                                                ContactResponse &response) {
  const SparseMatrix symmetric = symmetric_part(step.matrix);
  EquilibriumProblem problem{{symmetric, step.residual}, step.pose.dofs};
  problem.end = time;
  problem.increment = {loads.time_of_laws(time), step.h, model.contacts.temperatures(step.factors)};
  problem.largest_force = step.largest;
  problem.force_so_far =
      std::max(step.balance.free, largest(step.momentum_before) * ratio / (p.beta * step.h));
  if (!p.impulses)
    return linearized.solve(problem, from.contacts, change, response);
  const double reach = step.h * p.beta / p.gamma;
  contacts.set_matrix(symmetric);
  change.setZero(unknowns.size());
  EquilibriumResult result = contacts.solve(
      problem, from, problem.imposed - loads.imposed(time) + loads.imposed(from.time),
      {step.motion - reach * step.velocity - unknowns, reach, p.gamma / ratio,
       loads.may_jump(from.time, time)},
      change, response);
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
    const Pose beside = with_other_digits(model, step.pose);
    LineCells::Balance there;
    model.cells.evaluate(
        {beside, beside, beside, beside.dofs, 0., {time_of_laws, step.h}, nullptr, &step.start},
        step.factors, there);
    return largest(there.forces - step.balance.forces);
  };
  return is_balanced(model, step.matrix, size, force, step.pose, rounding, scale);
}

EquilibriumResult AlphaScheme::solve_yielding(Step &step, const LineState &from,
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
    if (step.balance.failed || !step.residual.allFinite()) {
      result.remark = step.balance.failed ? "a section that yields or creeps has no answer"
                                          : "the iteration diverges";
      return result;
    }
    if (judged && is_solved(step, loads.time_of_laws(time), response, result)) {
      result.converged = true;
      to.sections = step.balance.sections;
      return result;
    }
    const auto solve_here = [&]() {
      return solve_linearized(step, from, loads, time, to.unknowns, change, response);
    };
    if (!iterate(model.scene.solver.max_iterations, solve_here, result))
      return result;
    const Vector unknowns = to.unknowns;
    const auto slope_at = [&](const double length) {
      to.unknowns = unknowns + length * change;
      evaluate(loads, to.unknowns, time, step);
      return step.balance.failed ? std::numeric_limits<double>::max()
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

EnergyAccount AlphaScheme::account_yielding(const Step &step, const LineState &from,
                                            const LoadCourse &loads, const LineState &to) const {
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
  account.at_hand = kinetic + model.cells.stored_energy(pose_of(to)) +
                    model.linear.kinetic_by_imposed(to.load_rates, to.velocity);
  account.turnover += std::abs(account.kinetic);
  EnergyAccount imposed = account_imposed(model, from, to, step.h);
  imposed.external -= imposed.stored; // which the cells' account has
  imposed.stored = 0.;
  return account += imposed;
}

} // namespace frictionbeam
