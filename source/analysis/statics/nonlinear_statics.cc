// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/statics/nonlinear_statics.h"
#include "analysis/statics/slope_search.h"

#include "base/interruption.h"
#include "base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr double most_turn = 0.5; // of a vertex in one iteration [rad]

} // namespace

NonlinearStatics::NonlinearStatics(const Model &model)
    : model(model), linearized(model), motions(model) {
  if (!model.cells.pipe_sections().any() || model.cells.turns_far())
    return;
  const Pose rest = model.cells.at_rest();
  LineCells::Balance elastic;
  model.cells.evaluate({rest, rest, rest, rest.dofs, 0., {}, nullptr, &rest, true},
                       std::vector<double>(model.scene.loads.size(), 0.), elastic);
  linearized.keep(elastic.stiffness);
}

NonlinearStatics::Approach NonlinearStatics::begin(const LineState &from,
                                                   const StaticIncrement &increment) {
  const Pose pose = pose_of(from);
  LineCells::Balance &balance = balance_at_hand;
  model.cells.evaluate({pose, pose, pose, pose.dofs, 0., {}, nullptr, &pose, true},
                       from.load_factors, balance);
  const double largest_before =
      std::max(increment.least_force, balance.largest); // a line may lose all its forces
  const Vector imposed =
      increment.course.imposed(increment.time) - increment.course.imposed(from.time);
  Approach at{model.cells.moved(pose, imposed),
              Vector::Zero(from.unknowns.size()),
              increment.time,
              increment.factors,
              {increment.course.time_of_laws(increment.time), increment.time - from.time},
              pose,
              largest_before,
              balance};
  if (increment.lead)
    measure_rates(from, increment, at);
  return at;
}

namespace {
/// Time that an increment which is led is expected to take.
double expected_span(const LineState &from, const StaticIncrement &increment) {
  constexpr double least = 1e-3; // of what is left of the step
  return std::max(increment.time - from.time, least * (increment.lead->end - from.time));
}
} // namespace

void NonlinearStatics::measure_rates(const LineState &from, const StaticIncrement &increment,
                                     Approach &at) const {
  const PathLead &lead = *increment.lead;
  const double rest = lead.end - from.time;
  at.factor_rates.resize(lead.factors.size());
  for (unsigned int l = 0; l < lead.factors.size(); ++l)
    at.factor_rates[l] = (lead.factors[l] - from.load_factors[l]) / rest;
  at.imposed_rate =
      (increment.course.imposed(lead.end) - increment.course.imposed(from.time)) / rest;
  const Vector before = at.balance.forces;
  const double span = expected_span(from, increment);
  const Pose end = model.cells.moved(at.start, span * at.imposed_rate);
  std::vector<double> factors = from.load_factors;
  for (unsigned int l = 0; l < factors.size(); ++l)
    factors[l] += span * at.factor_rates[l];
  LineCells::Step step{end, end, end, end.dofs, 0., at.clock, nullptr, &at.start, true};
  model.cells.evaluate(step, factors, at.balance);
  at.force_rate = (at.balance.forces - before) / span;
  at.lead_stiffness = std::abs(at.balance.stiffness.coeff(lead.unknown, lead.unknown));
  at.goal = lead.before != nullptr ? lead.motion * at.force_rate.dot(*lead.before) : lead.motion;
}

void NonlinearStatics::load_further(const double more, Approach &at) const {
  at.time += more;
  at.clock.time += more;
  at.clock.length = std::max(at.clock.length + more, 0.);
  for (unsigned int l = 0; l < at.factors.size(); ++l)
    at.factors[l] += more * at.factor_rates[l];
  if (at.imposed_rate.lpNorm<Eigen::Infinity>() > 0.)
    at.pose = model.cells.moved(at.pose, more * at.imposed_rate);
}

EquilibriumResult
NonlinearStatics::solve_at_pose(const LineState &from, const StaticIncrement &increment,
                                const std::vector<Contact::Strains> &contact_forces, Approach &at,
                                Vector &change, ContactResponse &response, double &more) {
  EquilibriumProblem problem{{at.balance.stiffness, at.forces}, at.pose.dofs};
  problem.increment = {at.clock.time, 0., model.contacts.temperatures(at.factors)};
  problem.largest_force = at.largest;
  problem.force_so_far = std::max(increment.force_so_far, at.balance.free);
  problem.forces_before = &contact_forces;
  if (!increment.lead)
    return linearized.solve(problem, from.contacts, change, response);
  const PathLead &goal = *increment.lead;
  const bool by_work = goal.before != nullptr;
  const double left = at.goal - (by_work ? at.force_rate.dot(at.moved) : at.moved[goal.unknown]);
  LinearizedSolver::Lead lead{
      static_cast<int>(goal.unknown),           left,   at.goal, at.lead_stiffness, at.force_rate,
      expected_span(from, increment) / at.goal, by_work};
  const EquilibriumResult result =
      linearized.solve_led(problem, lead, from.contacts, change, response);
  more = lead.more;
  return result;
}

void NonlinearStatics::evaluate(Approach &at, const bool is_trial) const {
  LineCells::Step step{at.pose,  at.pose, at.pose,   at.pose.dofs, 0.,
                       at.clock, nullptr, &at.start, is_trial};
  step.is_near_last = at.is_answered;
  model.cells.evaluate(step, at.factors, at.balance);
  at.is_answered = !is_trial && !at.balance.failure;
  at.forces = at.balance.forces + model.contacts.platen_forces();
  at.largest = std::max(at.largest_before, at.balance.largest);
}

bool NonlinearStatics::is_solved(Approach &at, const ContactResponse &response,
                                 EquilibriumResult &result) const {
  Vector of_contacts = Vector::Zero(at.forces.size());
  model.contacts.add_forces(response, of_contacts);
  at.largest = std::max(at.largest, largest_contact_force(model.contacts, response));
  const Vector left = at.forces - of_contacts;
  const double size = left.size() > 0 ? left.lpNorm<Eigen::Infinity>() : 0.; // 0: all is held
  const double scale = std::max(at.largest, at.balance.free);
  result.residual = scale > 0. ? size / scale : size;
  const auto rounding = [&]() {
    LineCells::Balance beside;
    const Pose pose = with_other_digits(model, at.pose, false);
    model.cells.evaluate({pose, pose, pose, pose.dofs, 0., at.clock, nullptr, &at.start},
                         at.factors, beside);
    return (beside.forces - at.balance.forces).lpNorm<Eigen::Infinity>();
  };
  return is_balanced(model, largest_diagonal(at.balance.stiffness), size, at.largest, at.pose,
                     rounding, scale);
}

bool NonlinearStatics::follows_creep(const Approach &at, const LineState &from,
                                     const ContactResponse &response, EquilibriumResult &result) {
  // A contact that opens or closes bends the course of the stresses, which is taken for smooth.
  constexpr double of_bent_course = 0.03;
  const bool is_smooth =
      std::equal(from.contact_status.begin(), from.contact_status.end(), response.status.begin(),
                 response.status.end(), [](const ContactStatus before, const ContactStatus after) {
                   return (before == ContactStatus::open) == (after == ContactStatus::open);
                 });
  const double allowed = (is_smooth ? 1. : of_bent_course) * model.scene.solver.creep_tolerance;
  too_long = at.balance.section_error > allowed;
  if (!too_long)
    return true;
  result.remark = "the increment is too long for creep: a stress would be off by " +
                  rounded_number(at.balance.section_error, 2) + " of itself, Creep tolerance is " +
                  rounded_number(allowed, 2);
  return false;
}

bool NonlinearStatics::move(const Vector &change, Approach &at) const {
  Vector dofs;
  model.space.expand(change, dofs);
  const double turn =
      model.cells.turns_far() ? largest_turn(model.discretization, dofs) : 0.; // small ones add up
  const double part = turn > most_turn ? most_turn / turn : 1.;
  at.moved += part * change;
  at.pose = model.cells.moved(at.pose, part * dofs);
  return part == 1.;
}

bool NonlinearStatics::search(const Pose &from, const Vector &moved, const Vector &change,
                              const Vector &before, const Vector &of_contacts, Approach &at) const {
  const double slope = -(before - of_contacts).dot(change);
  if (model.cells.turns_far() && slope >= 0.) { // where the potential is not convex
    evaluate(at, false);
    return true;
  }
  Vector dofs;
  model.space.expand(change, dofs);
  const auto slope_at = [&](const double length) {
    at.moved = moved + length * change;
    at.pose = model.cells.moved(from, length * dofs);
    evaluate(at, false);
    return at.balance.failure ? std::numeric_limits<double>::max()
                              : -(at.forces - of_contacts).dot(change);
  };
  return search_slope(slope, slope_at) == 1.;
}

namespace {
/// Whether the forces left over have hardly changed in several steps, the last of which began with
/// @p before.
bool gives_way(const Vector &before, const NonlinearStatics::Approach &at, unsigned int &in_vain) {
  constexpr double hardly = 0.05;
  constexpr unsigned int several = 6;
  const bool is_same =
      (at.forces - before).lpNorm<Eigen::Infinity>() <= hardly * before.lpNorm<Eigen::Infinity>();
  in_vain = is_same ? in_vain + 1 : 0;
  return in_vain == several;
}
} // namespace

EquilibriumResult NonlinearStatics::solve(const LineState &from, const StaticIncrement &increment,
                                          LineState &to, ContactResponse &response) {
  Approach at = begin(from, increment);
  too_long = false;
  EquilibriumResult result;
  Vector change;
  bool judged = false; // whether the contacts' forces are those at the pose
  const bool may_search =
      model.cells.pipe_sections().any() && !(model.cells.turns_far() && increment.finds_limit &&
                                             !increment.lead && model.contacts.size() == 0);
  bool is_searched = false;
  unsigned int steps_in_vain = 0;
  std::vector<Contact::Strains> contact_forces = from.contact_stress;
  for (;;) {
    interruption::end_if_overdue();
    // Sections that yield begin with what they would do elastically, whatever they did before.
    if (!is_searched)
      evaluate(at, result.iterations == 0);
    if (at.balance.failure || !at.forces.allFinite()) {
      result.remark = at.balance.failure ? at.balance.failure : "the iteration diverges";
      remember_failure(at, from, increment);
      return result;
    }
    if (judged && is_solved(at, response, result)) {
      if (!follows_creep(at, from, response, result))
        return result;
      result.converged = true;
      to.sections.swap(at.balance.sections);
      if (model.cells.pipe_sections().any())
        motions.add_solved(at.moved, at.balance.stiffness);
      to.time = at.time;
      to.unknowns = from.unknowns + at.moved;
      set_pose(model, at.pose, to);
      return result;
    }
    double more = 0.;
    const auto solve_linearized = [&]() {
      return solve_at_pose(from, increment, contact_forces, at, change, response, more);
    };
    if (!iterate(model.scene.solver.max_iterations, solve_linearized, result)) {
      remember_failure(at, from, increment);
      return result;
    }
    contact_forces = response.stress;
    Vector forces = at.forces;
    if (increment.lead) {
      forces += more * at.force_rate;
      load_further(more, at);
    }
    const Vector moved = at.moved;
    const Pose pose = at.pose;
    judged = move(change, at);
    // Beyond the limit of supports that slip nothing helps: far motions show the mechanism then.
    is_searched =
        judged && result.iterations > 1 && may_search &&
        (model.contacts.size() == 0 || 2 * result.iterations < model.scene.solver.max_iterations);
    if (is_searched) {
      Vector of_contacts = Vector::Zero(forces.size());
      model.contacts.add_forces(response, of_contacts);
      judged = search(pose, moved, change, forces, of_contacts, at) || model.contacts.size() == 0;
    }
    if (is_searched && model.contacts.size() == 0 && gives_way(forces, at, steps_in_vain)) {
      result.remark = "the line gives way: it moves on and on without coming nearer to equilibrium";
      remember_failure(at, from, increment);
      return result;
    }
  }
}

void NonlinearStatics::remember_failure(const Approach &at, const LineState &from,
                                        const StaticIncrement &increment) {
  if (model.cells.pipe_sections().any())
    motions.add_failure(at.moved, at.balance.stiffness, at.forces,
                        increment.course.forces(increment.factors) -
                            increment.course.forces(from.load_factors));
}

void NonlinearStatics::transfer(Archive &archive) { archive(linearized, motions); }

Vector NonlinearStatics::forces_on_contacts(const LineState &state, const LoadCourse &) const {
  LineCells::Balance balance;
  model.cells.evaluate(pose_of(state), state.load_factors, balance);
  return balance.forces + model.contacts.platen_forces();
}

std::optional<Collapse> NonlinearStatics::collapse(const LineState &at,
                                                   const std::vector<double> &begin,
                                                   const std::vector<double> &end) const {
  if (!model.cells.pipe_sections().any())
    return {};
  return motions.collapse(at, begin, end);
}

EnergyAccount NonlinearStatics::account(const LineState &before, const LineState &after,
                                        const LoadCourse &course, const Vector &unbalanced) const {
  EnergyAccount account = account_cells(model, before, after, before.load_factors,
                                        course.imposed(after.time) - course.imposed(before.time));
  account += account_contacts(model, before, after, {});
  account.external -= unbalanced.dot(after.unknowns - before.unknowns) / 2.;
  return account;
}

} // namespace frictionbeam
