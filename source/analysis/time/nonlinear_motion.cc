// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/nonlinear_motion.h"

#include "analysis/statics/slope_search.h"
#include "analysis/time/step_helpers.h"
#include "base/interruption.h"
#include "model/unknowns/line_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

using namespace dealii;

NonlinearMotion::NonlinearMotion(const Model &model)
    : model(model), has_mass(unknowns_with_mass(model.cells.mass())),
      is_smooth(model.contacts.size() == 0 && !model.cells.pipe_sections().any()), contacts(model),
      linearized(model), inertia(model.scene.loads.size()) {
  for (unsigned int l = 0; l < inertia.size(); ++l)
    if (model.linear.accelerates(l))
      inertia[l] = model.cells.inertia(l);
}

std::string NonlinearMotion::name() const {
  return "moreau_jean: midpoint rule with exact momentum in corotational kinematics, rigid contact "
         "and friction by impulses";
}

void NonlinearMotion::start(LineState &state, const LoadCourse &) {
  state.acceleration = state.auxiliary = Vector::Zero(state.unknowns.size());
}

void NonlinearMotion::evaluate(const LineState &state, const Matrix matrix, Step &step) const {
  const LineCells &line = model.cells;
  const double h = step.h;
  model.space.expand(step.moved, step.change);
  step.change += step.imposed;
  step.to = line.stepped(step.from, step.change);
  step.half = line.halfway(step.from, step.to);
  const bool wants_matrix = matrix == Matrix::tangent;
  LineCells::Step motion{step.from,           step.half,           step.to, step.change, h,
                         {step.start + h, h}, &step.factors_at_end};
  motion.without_stiffness = !wants_matrix;
  motion.is_near_last = step.is_answered;
  line.evaluate(motion, step.factors, step.balance);
  step.is_answered = !step.balance.failure;

  // The equation of motion divided by h/2.
  const double lost = model.scene.time.mass_damping * h / 2.; // part of the momentum
  const Vector inertia =
      line.mass() * (4. * (1. + lost) / (h * h) * step.moved - 4. / h * state.velocity) +
      2. / h * step.imposed_impulse;
  step.residual = 2. * (step.balance.forces + model.contacts.platen_forces()) - inertia;
  contacts.take_elastic_forces(state, 1., step.residual);
  if (wants_matrix) {
    step.matrix = step.balance.stiffness;
    add_within(4. * (1. + lost) / (h * h), line.mass(), step.matrix);
  }
  line.add_rotary(step.from, step.to, step.change, step.velocity, h, step.residual,
                  wants_matrix ? &step.matrix : nullptr);
  step.largest = std::max(2. * step.balance.largest, inertia.lpNorm<Eigen::Infinity>());
}

double NonlinearMotion::rounding_of(const Step &step) const {
  const Pose to = with_other_digits(model, step.to, true);
  const Pose half = model.cells.halfway(step.from, to);
  LineCells::Step motion{step.from,           half,   to,
                         step.change,         step.h, {step.start + step.h, step.h},
                         &step.factors_at_end};
  motion.without_stiffness = true;
  LineCells::Balance beside;
  model.cells.evaluate(motion, step.factors, beside);
  return 2. * (beside.forces - step.balance.forces).lpNorm<Eigen::Infinity>();
}

double NonlinearMotion::digits_of(const Step &step) const {
  const double place = std::max(largest_coordinate(model.discretization),
                                largest_displacement(model.discretization, step.to.dofs));
  constexpr double negligible = 1e-12; // of the largest force
  return std::min(std::numeric_limits<double>::epsilon() * step.stiffness * place,
                  negligible * step.largest);
}

EquilibriumResult NonlinearMotion::solve_linearized(const LineState &state, const LoadCourse &loads,
                                                    const double time, Step &step, Vector &change,
                                                    ContactResponse &response) {
  step.stiffness = largest_diagonal(step.matrix);
  if (model.contacts.size() == 0) {
    EquilibriumProblem problem{{step.matrix, step.residual}, step.to.dofs};
    return linearized.solve(problem, state.contacts, change, response);
  }
  const double h = step.h;
  const SparseMatrix symmetric = symmetric_part(step.matrix);
  contacts.set_matrix(symmetric);
  // In what the unknowns still have to move beyond the pose.
  EquilibriumProblem problem{{symmetric, step.residual}, step.to.dofs};
  problem.end = time;
  problem.increment = {loads.time_of_laws(time), h,
                       model.contacts.temperatures(loads.factors_before(time))};
  problem.largest_force = step.largest;
  problem.force_so_far = step.without_force();
  change.setZero(step.moved.size());
  EquilibriumResult result = contacts.solve(
      problem, state, loads, {h / 2. * state.velocity - step.moved, h / 2., 0.5}, change, response);
  result.no_equilibrium = false;
  return result;
}

Vector NonlinearMotion::unbalanced(const Step &step, const ContactResponse &response) const {
  Vector left = step.residual;
  if (model.contacts.size() > 0) {
    Vector of_contacts = Vector::Zero(left.size());
    model.contacts.add_forces(response, of_contacts);
    // Of the impulses the response has the mean over the step, a half.
    left -= of_contacts - contacts.impulses() / step.h;
  }
  return left;
}

bool NonlinearMotion::is_solved(const Step &step, const Vector &left,
                                const ContactResponse &response, EquilibriumResult &result) const {
  const double size = left.lpNorm<Eigen::Infinity>(),
               largest = std::max(step.largest, largest_contact_force(model.contacts, response));
  const double scale = std::max(largest, step.without_force());
  result.residual = scale > 0. ? size / scale : size;
  return is_balanced(
      model, step.stiffness, size, largest, step.to, [&]() { return rounding_of(step); }, scale);
}

EquilibriumResult NonlinearMotion::solve(const LineState &state, const LoadCourse &loads,
                                         const double time, Step &step, ContactResponse &response) {
  // Makes an iteration the residual smaller: the first, with factors of another pose; any other;
  // one that goes on to rounding.
  constexpr double well_at_first = 1e-3, well = 0.02, at_all = 0.5;
  EquilibriumResult result;
  Vector change;
  bool judged = false; // whether the contacts' forces are those at the pose
  double size_before = 0.;
  unsigned int again = 0;
  for (;;) {
    interruption::end_if_overdue();
    // Where the step before had to have other factors, a pose is asked for both at once: to the
    // same answer, at less cost.
    const bool looks_ahead = is_smooth && judged && result.iterations == factored_again;
    evaluate(state, !judged || looks_ahead ? Matrix::tangent : Matrix::none, step);
    if (step.balance.failure || !step.residual.allFinite()) {
      result.remark = step.balance.failure ? step.balance.failure : "the iteration diverges";
      return result;
    }
    bool by_last_factors = false;
    if (judged) {
      const Vector left = unbalanced(step, response);
      const double size = left.lpNorm<Eigen::Infinity>();
      // Factors that do well go on to rounding, for momentum and energy of the whole.
      const bool may_go_on = is_smooth && size > digits_of(step);
      by_last_factors =
          may_go_on && size <= (result.iterations == 1 ? well_at_first : well) * size_before;
      if (!by_last_factors && is_solved(step, left, response, result)) {
        by_last_factors = may_go_on && size <= at_all * size_before;
        result.converged = !by_last_factors;
        if (result.converged) {
          factored_again = again;
          return result;
        }
      }
      size_before = size;
      if (!by_last_factors) {
        if (!looks_ahead)
          evaluate(state, Matrix::tangent, step);
        if (again == 0)
          again = result.iterations;
      }
      // The contacts are solved with a symmetric matrix. What the line itself makes of their forces
      // is left to its own, so that only the contacts' share converges more slowly.
      if (model.contacts.size() > 0 && model.cells.turns_far() &&
          linearized.solve_without_contacts(step.matrix, left, change)) {
        ++result.factorizations;
        step.moved += change;
        evaluate(state, Matrix::tangent, step);
        if (!step.residual.allFinite())
          continue;
      }
    } else
      size_before = step.residual.size() > 0 ? step.residual.lpNorm<Eigen::Infinity>() : 0.;
    const auto solve_at_pose = [&]() {
      if (by_last_factors) {
        change = linearized.solve_again(step.residual);
        EquilibriumResult solved;
        solved.converged = true;
        return solved;
      }
      return solve_linearized(state, loads, time, step, change, response);
    };
    if (!iterate(model.scene.solver.max_iterations, solve_at_pose, result))
      return result;
    if (result.iterations > 1 && model.cells.pipe_sections().any() && !model.cells.turns_far())
      judged = search(state, step, change, response) || model.contacts.size() == 0;
    else {
      step.moved += change;
      judged = true;
    }
  }
}

bool NonlinearMotion::search(const LineState &state, Step &step, const Vector &change,
                             const ContactResponse &response) const {
  const double slope = -unbalanced(step, response).dot(change);
  const Vector moved = step.moved;
  const auto slope_at = [&](const double length) {
    step.moved = moved + length * change;
    evaluate(state, Matrix::tangent, step);
    return step.balance.failure ? std::numeric_limits<double>::max()
                                : -unbalanced(step, response).dot(change);
  };
  return search_slope(slope, slope_at) == 1.;
}

void NonlinearMotion::account(const Step &step, const Vector &velocity_after,
                              EnergyAccount &account) const {
  const LineCells &line = model.cells;
  const double h = step.h, lost = model.scene.time.mass_damping * h / 2.;
  const Vector before = line.momenta(step.from, step.velocity),
               after = line.momenta(step.to, velocity_after);
  const double kinetic = velocity_after.dot(after) / 2., stored = line.stored_energy(step.to);
  account.stored = stored - line.stored_energy(step.from);
  account.kinetic = kinetic - step.velocity.dot(before) / 2.;
  Vector mean_velocity = (step.change - step.imposed) / h + step.imposed_velocity;
  account.damping = step.balance.damping + lost * mean_velocity.dot(before + after);
  account.external = step.balance.loads.dot(step.change) + step.balance.free_work +
                     model.contacts.platen_forces().dot(step.moved) +
                     (step.balance.internal - step.balance.loads).dot(step.imposed) +
                     step.imposed_velocity.dot((1. + lost) * after - (1. - lost) * before);
  account.at_hand = kinetic + std::abs(stored); // below 0 where sections jump
  if (line.pipe_sections().any())
    account.inelastic = line.pipe_sections().dissipated(*step.to.sections) -
                        line.pipe_sections().dissipated(*step.from.sections);
  account.turnover = std::abs(account.external) + std::abs(account.stored) +
                     std::abs(account.kinetic) + std::abs(account.inelastic);
}

void NonlinearMotion::finish(const LineState &state, Step &step, ContactResponse &response,
                             LineState &to, TimeStep &report) {
  const LineCells &line = model.cells;
  const double h = step.h;
  to.unknowns = state.unknowns + step.moved;
  set_pose(model, step.to, to);
  to.sections = step.balance.sections;
  step.to.sections = &to.sections;
  to.velocity = 2. / h * step.moved - state.velocity;
  for (int i = 0; i < to.velocity.size(); ++i)
    if (!has_mass[i])
      to.velocity[i] = step.moved[i] / h;
  line.set_spins(step.from, step.to, step.change, step.velocity, h, to.velocity);
  to.acceleration = (to.velocity - state.velocity) / h;
  to.auxiliary = to.acceleration;
  commit_contacts(response, state.contact_status, to);
  if (model.contacts.size() > 0)
    contacts.add_histories(state, h, to);
  account(step, model.cells.velocities(to.velocity, to.load_rates), report.energy);
  report.energy += account_contacts(
      model, state, to, model.contacts.size() > 0 ? contacts.work() : std::vector<ContactWork>());
  double jerk = 0.;
  for (int i = 0; i < to.velocity.size(); ++i)
    if (has_mass[i])
      jerk = std::max(jerk, std::abs(to.auxiliary[i] - state.auxiliary[i]));
  report.error = h * h / 12. * jerk;
}

NonlinearMotion::Step NonlinearMotion::begin(const LineState &from, const LoadCourse &loads,
                                             const LineState &to) const {
  Step step;
  step.h = to.time - from.time;
  step.start = loads.time_of_laws(from.time);
  step.from = pose_of(from);
  step.moved = step.h * from.velocity;
  step.momentum = 2. / step.h * (model.cells.mass() * from.velocity).lpNorm<Eigen::Infinity>();
  step.imposed = loads.imposed(to.time) - loads.imposed(from.time);
  step.factors = step.factors_at_end = to.load_factors;
  const std::vector<double> before = loads.factors_after(from.time);
  for (unsigned int l = 0; l < step.factors.size(); ++l)
    step.factors[l] = (step.factors[l] + before[l]) / 2.;
  step.velocity = model.cells.velocities(from.velocity, from.load_rates);
  step.imposed_velocity.setZero(model.space.n_dofs());
  step.imposed_impulse.setZero(model.space.n_unknowns());
  const double lost = model.scene.time.mass_damping * step.h / 2.;
  for (unsigned int l = 0; l < to.load_rates.size(); ++l) {
    if (!model.linear.accelerates(l))
      continue;
    for (const auto &[dof, value] : model.linear.imposed(l))
      step.imposed_velocity[dof] += (from.load_rates[l] + to.load_rates[l]) / 2. * value;
    step.imposed_impulse -=
        ((1. + lost) * to.load_rates[l] - (1. - lost) * from.load_rates[l]) * inertia[l];
  }
  return step;
}

TimeStep NonlinearMotion::advance(const LineState &from, const LoadCourse &loads, const double time,
                                  LineState &to) {
  to = from;
  to.time = time;
  to.load_factors = loads.factors_before(time);
  loads.set_rates(to, LoadCourse::Side::before);
  Step step = begin(from, loads, to);
  TimeStep report;
  ContactResponse response;
  report.result = solve(from, loads, time, step, response);
  if (report.result.converged)
    finish(from, step, response, to, report);
  return report;
}

} // namespace frictionbeam
