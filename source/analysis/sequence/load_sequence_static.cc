// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/sequence/load_sequence.h"
#include "base/number_text.h"
#include "base/numbers.h"

#include "analysis/contact/opposed_contacts.h"
#include "analysis/increment/follow_resolution.h"
#include "analysis/increment/report_result.h"
#include <frictionbeam/contact/tolerances.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {
constexpr unsigned int most_contacts_for_uniqueness = 100; // the check is quadratic in them
/// What an increment with all its halves gets before it is given up: three times as much as any
/// case that was ever solved has taken.
constexpr unsigned int most_iterations = 50000, most_halvings = 200;
constexpr unsigned int most_halvings_of_creep = 50; // of an increment: a millionth of a billionth

/// More where the user allows more.
unsigned int most_iterations_of(const SolverSettings &settings) {
  return std::max(most_iterations, settings.has_tangent() ? settings.max_iterations
                                                          : settings.max_elastic_iterations);
}

/// What of a static step's answer is not the only one.
std::vector<contact::BeyondUniqueness>
several_equilibria(const Model &model, const Statics &statics, const LineState &state) {
  std::vector<ContactStatus> status = state.contact_status;
  const std::vector<bool> idle = idle_halves(model.contacts, state);
  for (unsigned int i = 0; i < status.size(); ++i)
    if (idle[i]) // touches without a force: the other half of a stop holds for it
      status[i] = ContactStatus::open;
  return statics.beyond_uniqueness(status);
}
} // namespace

bool LoadSequence::run_static(const Factors &target, const Observer &observer) {
  const unsigned int step = position.step;
  const LoadStep &declared_step = model.scene.steps[step];
  const double start = position.start;
  if (!is_resumed) {
    current.velocity.setZero();
    current.acceleration.setZero();
    current.auxiliary.setZero();
    current.load_rates.clear();
    current.load_accelerations.clear();
  }
  const bool begins = !is_resumed && step == 0;
  is_resumed = false;
  measure_forces(course.forces(current.load_factors));
  if (begins && !settle())
    return false;
  // Of lines that yield, halving the increments finds what is carried if the path is lost.
  if (declared_step.finds_limit && has_path() && !run_to_limit(observer) &&
      !model.cells.pipe_sections().any())
    return false;
  for (std::size_t &i = position.next; i < declared_step.n_increments;) {
    ++i;
    const double end = i == declared_step.n_increments
                           ? start + declared_step.duration
                           : start + declared_step.duration * i / declared_step.n_increments;
    if (!follow_to(end, i == declared_step.n_increments, target)) {
      StepReport &report = step_reports.back();
      const bool is_collapse =
          report.limit && report.limit->bound <= widest_limit * report.limit->reached;
      if (!declared_step.finds_limit || !(is_collapse || has_jumped))
        return false; // it was not the loads
      report.no_equilibrium = false;
      report.remark.clear();
      if (!is_collapse)
        end_at_limit("beyond it the line jumps to a pose far away; before, it moves most at ");
      current.time = start + declared_step.duration; // where the next step's time begins
      i = declared_step.n_increments;                // it ends here
    }
    // The last frame of a long line is as large as its method, which it has no use for.
    if (own_statics && i == declared_step.n_increments && step + 1 == model.scene.steps.size() &&
        model.contacts.size() > most_contacts_for_uniqueness)
      statics.hold_less();
    observer({step, static_cast<unsigned int>(i), declared_step.n_increments}, current);
    if (between_increments)
      between_increments();
  }
  if (!step_reports.back().limit && statics.is_unstable(current))
    step_reports.back().warning =
        "Step " + declared_step.name +
        ": the equilibrium is unstable, whatever closed supports hold by their stiffness: a "
        "line in this pose leaves it at the least push. If it has gone there by itself, it is not "
        "where the line goes: take more increments, or a transient step.";
  if (declared_step.finds_limit && !step_reports.back().limit)
    end_with_all_loads();
  if (judges && model.scene.solver.is_exact() &&
      model.contacts.size() <= most_contacts_for_uniqueness)
    step_reports.back().several_equilibria = several_equilibria(model, statics, current);
  return true;
}

bool LoadSequence::settle() {
  const Factors factors = course.factors_at(current.time, side);
  if (course.forces(factors).isZero(0.))
    return true;
  iterations_left = most_iterations_of(model.scene.solver);
  LineState to = current;
  last_result = solve_statics(factors, current.time, {}, to);
  if (!add_result(last_result, step_reports.back())) {
    step_reports.back().remark = "stopped before the first loads: " + step_reports.back().remark;
    return false;
  }
  take(std::move(to), declared, current.time);
  return true;
}

bool LoadSequence::follow_to(const double end, const bool is_last, const Factors &target) {
  const double start = position.start, duration = model.scene.steps[position.step].duration;
  const Factors &from = position.from;
  for (bool done = false; !done;) {
    iterations_left = most_iterations_of(model.scene.solver);
    halvings_left = most_halvings;
    if (course.forces_jump(current.time)) {
      if (!advance_to_other_side())
        return false;
      show_part();
    }
    const double corner = course.next_break(current.time);
    done = !(corner < end - same_instant_of_step * duration);
    const double time = done ? end : corner, part = (time - start) / duration;
    Factors to = target;
    if (!done || !is_last)
      for (unsigned int l = 0; l < to.size(); ++l)
        to[l] = from[l] + part * (target[l] - from[l]);
    iterations_left = most_iterations_of(model.scene.solver);
    halvings_left = most_halvings;
    if (!advance(Factors(declared), to, time, 0))
      return false;
    if (!done)
      show_part();
  }
  return true;
}

void LoadSequence::show_part() const {
  part_observer({position.step, static_cast<unsigned int>(position.next) - 1,
                 model.scene.steps[position.step].n_increments, false, true},
                current);
}

bool LoadSequence::advance_to_other_side() {
  side = LoadCourse::Side::after;
  const bool done = advance(Factors(declared), Factors(declared), current.time, 0);
  side = LoadCourse::Side::before;
  return done;
}

bool LoadSequence::advance(const Factors &from, const Factors &to, const double time,
                           const unsigned int halvings) {
  StepReport &report = step_reports.back();
  const double start = current.time;
  if (solve_increment(to, time)) {
    ++report.increments;
    if (each_increment)
      each_increment({static_cast<unsigned int>(step_reports.size() - 1), report.increments, 0},
                     current);
    return true;
  }
  if (report.no_equilibrium) {
    report.remark = "stopped at time " + rounded_number(start, 6) + ": " + report.remark;
    return false;
  }
  if (last_result.rounding_bars || iterations_left == 0 || halvings_left == 0) {
    report.remark = "stopped at time " + rounded_number(start, 6) + ": " + report.remark;
    if (!last_result.rounding_bars)
      report.remark += "; one increment gets " +
                       std::to_string(most_iterations_of(model.scene.solver)) + " iterations and " +
                       std::to_string(most_halvings) + " halvings in all";
    return false;
  }
  const bool finds_limit = model.scene.steps[position.step].finds_limit;
  const auto limit = finds_limit ? bound_of_yield() : std::optional<LimitLoad>();
  if (limit && limit->bound <= (1. + open_by_proof) * limit->reached) {
    judge_collapse(report);
    return false;
  }
  if (halvings >= model.scene.solver.max_halvings &&
      (!statics.wants_shorter() || halvings == most_halvings_of_creep)) {
    report.remark = "stopped at time " + rounded_number(start, 6) + ": " + report.remark +
                    ", also after halving the increment " + std::to_string(halvings) + " times";
    judge_collapse(report);
    return false;
  }
  ++report.halvings;
  --halvings_left;
  Factors middle(to.size());
  for (unsigned int l = 0; l < to.size(); ++l)
    middle[l] = (from[l] + to[l]) / 2.;
  if (!advance(from, middle, (start + time) / 2., halvings + 1))
    return false;
  show_part();
  return advance(middle, to, time, halvings + 1);
}

void LoadSequence::judge_collapse(StepReport &report) const {
  constexpr double share_of_elastic = 1e-3; // which the bound leaves out
  const auto limit = bound_of_yield();
  if (!limit)
    return;
  report.limit = limit;
  const std::string reached = rounded_number(limit->reached, 6);
  if (limit->bound * (1. + share_of_elastic) < 1.) {
    report.no_equilibrium = true;
    report.remark =
        "the pipes yield: " + reached + " of the way of this step's loads was carried, " +
        rounded_number(limit->bound, 6) +
        " is the most that any state of stress carries (rigid-plastic bound of the last "
        "motion); " +
        limit->mechanism;
  } else
    report.remark +=
        "; " + reached + " of the way of this step's loads was carried; " + limit->mechanism;
}

void LoadSequence::measure_forces(const Vector &loads) {
  if (loads.size() > 0)
    force_so_far = std::max(force_so_far, loads.lpNorm<Eigen::Infinity>());
  for (unsigned int i = 0; i < current.contact_stress.size(); ++i)
    force_so_far =
        std::max(force_so_far, model.contacts[i].largest_force(current.contact_stress[i]));
}

Vector LoadSequence::unbalanced_at_start() const {
  Vector forces = Vector::Zero(current.unknowns.size());
  if (in_equilibrium)
    return forces;
  ContactResponse of_contacts;
  of_contacts.stress = current.contact_stress;
  model.contacts.add_forces(of_contacts, forces);
  return statics.forces_on_contacts(current, course) - forces;
}

void LoadSequence::judge_increment(const LineState &before, EnergyAccount account) {
  StepReport &report = step_reports.back();
  report.energy += account;
  if (account.inelastic > 0.)
    ++report.resolution.flow_increments;
  check_sections(model, current, report);
  resolution->add_increment(before, current, report.resolution);
  report.resolution.loads_bend_within =
      report.resolution.loads_bend_within ||
      (model.contacts.size() > 0 && !course.is_straight(before.time, current.time));
  double largest = 0.;
  for (const Contact::Strains &stress : before.contact_stress)
    largest = std::max(largest, stress.head<3>().norm());
  for (unsigned int i = 0; i < model.contacts.size(); ++i)
    if (before.contact_status[i] == ContactStatus::stick &&
        current.contact_status[i] == ContactStatus::open &&
        before.contact_stress[i].segment<2>(1).norm() > 1e-6 * largest &&
        std::count(report.torn_off.begin(), report.torn_off.end(), i) == 0)
      report.torn_off.push_back(i);
}

EquilibriumResult LoadSequence::solve_statics(const Factors &full, const double time,
                                              const std::optional<PathLead> &lead, LineState &to) {
  EquilibriumResult result =
      statics.solve(current,
                    {course, time, full, contact::least_force * force_so_far, force_so_far,
                     iterations_left, model.scene.steps[position.step].finds_limit, lead},
                    to, response);
  iterations_left -= std::min(iterations_left, result.iterations);
  return result;
}

std::vector<double *> LoadSequence::flags_of_turned_slip() {
  std::vector<double *> flags;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (response.status[i] != ContactStatus::slip || !contact.law.has_closed_form())
      continue;
    const FrictionThreshold &law = contact.law.closed_form();
    if (law.dynamic_friction == law.static_friction)
      continue;
    double &was_slipping = current.contacts.internal[contact.state_offset + law.was_slipping];
    if (was_slipping != 0. &&
        current.contact_stress[i].segment<2>(1).dot(response.stress[i].segment<2>(1)) < 0.)
      flags.push_back(&was_slipping);
  }
  return flags;
}

bool LoadSequence::solve_increment(const Factors &factors, const double time) {
  LineState to = current;
  std::vector<double *> rested; // flags of contacts that slip as the increment begins
  const auto solve = [&]() {
    last_result = solve_statics(course.factors_at(time, side), time, {}, to);
    return add_result(last_result, step_reports.back());
  };
  bool is_solved = solve();
  while (is_solved) {
    const std::vector<double *> flags = flags_of_turned_slip();
    if (flags.empty())
      break;
    for (double *const flag : flags)
      *flag = 0.;
    rested.insert(rested.end(), flags.begin(), flags.end());
    to = current;
    is_solved = solve();
  }
  for (double *const flag : rested)
    *flag = 1.;
  has_jumped = false;
  if (!is_solved)
    return false;
  if (jumps(to, time)) {
    has_jumped = true;
    return false;
  }
  if (!model.scene.steps[position.step].finds_limit) {
    take(std::move(to), factors, time);
    return true;
  }
  const Vector moved = to.unknowns - current.unknowns;
  const double done = part_done();
  take(std::move(to), factors, time);
  path.add(moved, part_done() - done, part_done());
  return true;
}

void LoadSequence::take(LineState to, const Factors &factors, const double time) {
  const Vector unbalanced = judges ? unbalanced_at_start() : Vector();
  const LineState before = std::move(current);
  current = std::move(to);
  commit(factors, time);
  for (unsigned int i = 0; i < model.contacts.size(); ++i)
    if (model.contacts[i].law.has_closed_form())
      current.contacts.dissipated[i] =
          before.contacts.dissipated[i] + friction_work(model.contacts[i], i, before, current);
  measure_forces(course.forces(current.load_factors));
  if (judges)
    judge_increment(before, statics.account(before, current, course, unbalanced));
  in_equilibrium = true;
}

} // namespace frictionbeam
