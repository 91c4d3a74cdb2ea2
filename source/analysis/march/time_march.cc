// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/march/time_march.h"
#include "base/number_text.h"
#include "base/numbers.h"

#include "analysis/contact/undetermined_forces.h"
#include "analysis/increment/contact_watch.h"
#include "analysis/increment/follow_resolution.h"
#include "analysis/increment/report_result.h"
#include "analysis/increment/time_step.h"
#include "analysis/march/behind_jump.h"
#include "analysis/march/integrator_library.h"
#include "analysis/march/load_jumps.h"
#include "analysis/march/time_instants.h"
#include "scene/steps/step_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frictionbeam {

namespace {
constexpr double not_solved = -1.;          ///< in place of a time step's error
constexpr unsigned int most_failures = 200; ///< of time steps from one instant to the next
constexpr double most_gained = 0.1;         ///< by a time step, of the largest energy in motion

constexpr double least_jump = 1e-6; ///< of a rate: rates are differences over a time step

/// Whether the line may have been where a load puts its points at the run's beginning.
bool begins_displaced(const Scene &scene) {
  return std::any_of(
      scene.initial.begin(), scene.initial.end(),
      [](const InitialCondition &initial) { return initial.displacement != Motion{}; });
}

/// Whether a load moves points behind a jump at another rate than before, of which nothing may be
/// known: then they stood.
bool rates_jump(const std::vector<double> &before, const std::vector<double> &after) {
  for (unsigned int l = 0; l < after.size(); ++l) {
    const double rate = before.empty() ? 0. : before[l];
    if (std::abs(after[l] - rate) > least_jump * std::max(std::abs(after[l]), std::abs(rate)))
      return true;
  }
  return false;
}

bool is_any(const LoadCourse::Factors &jumps) {
  return std::any_of(jumps.begin(), jumps.end(), [](const double jump) { return jump != 0.; });
}

/// Energy in the last bits of what contacts' forces f would give in @p step to the masses that they
/// press on, (f h)^2 / (2 m), if nothing else held these [J]: where nothing moves, all is less.
double energy_of_rounding(const Model &model, const LineState &state, const double step) {
  constexpr double rounding = 1e-12;
  Vector impulse = Vector::Zero(state.unknowns.size());
  for (unsigned int i = 0; i < model.contacts.size(); ++i)
    model.contacts[i].add_to(impulse, state.contact_stress[i], step);
  const Vector mass = model.linear.mass().diagonal();
  double energy = 0.;
  for (Eigen::Index j = 0; j < mass.size(); ++j)
    if (mass[j] > 0.)
      energy += impulse[j] * impulse[j] / (2. * mass[j]);
  return rounding * energy;
}
} // namespace

TimeMarch::TimeMarch(const Model &model, const PieceObserver &observer)
    : model(model), integrator(make_time_integrator(model, observer)),
      may_share_forces(model.scene.solver.is_exact() && share_unknowns(model.contacts)) {}

void TimeMarch::transfer(Archive &archive) {
  archive(instant, n_increments, time_step, last_error, contacts_before, *integrator);
}

bool TimeMarch::run(const TransientStep &step, const LoadCourse &course_of_step,
                    LineState &line_state, StepReport &step_report, const Watchers &watching,
                    const bool resumed) {
  const LoadStep &declared = model.scene.steps[step.step];
  course = &course_of_step;
  state = &line_state;
  report = &step_report;
  watchers = &watching;
  step_number = step.step;
  longest_step = frictionbeam::time_step(model);
  const double start = step.start, end = start + declared.duration;
  const std::vector<double> times = integrator->is_exact()
                                        ? instants_of_output(model, start, end, longest_step)
                                        : instants_of_steps(*course, start, end, longest_step);
  if (!resumed) {
    instant = n_increments = 0;
    const LoadCourse::Factors before =
        std::exchange(state->load_factors, course->factors_after(start));
    report->remark =
        forbidden_by_damping(model, course->jumps_between(before, state->load_factors, start));
    if (!report->remark.empty())
      return false;
    if (step_before(model.scene, step_number) || !begins_displaced(model.scene))
      report->warning = jumps_of_motions(model, *course, before, start, end, declared.name);
    state->events.clear(); // those of a static increment are no impacts
    set_rates_before();
    report->velocity_jumps =
        loads_with_velocity_jumps(model, *course, state->load_rates, start, end);
    if (integrator->is_exact())
      integrator->start(*state, *course);
    else
      pass_jump(before);
    time_step = longest_step;
    jump_met = start;
    contacts_before = {};
    contacts_before.take(model, *state);
  }
  for (; instant < times.size(); ++instant) {
    const auto observe = [&]() {
      const unsigned int increment = ++n_increments;
      const bool last = state->time == end;
      const std::size_t left = times.size() - instant;
      watchers->of_instants(
          {step_number, increment, last ? increment : increment + static_cast<unsigned int>(left)},
          *state);
    };
    if (!move_to(times[instant], observe))
      return false;
  }
  course->set_rates(*state, LoadCourse::Side::before); // for a step that follows
  report->remark = integrator->remark();
  if (const std::string warning = integrator->warning(); !warning.empty())
    report->warning += (report->warning.empty() ? "" : " ") + warning;
  return true;
}

void TimeMarch::set_rates_before() {
  const auto last = step_before(model.scene, step_number);
  if (!last)
    state->load_rates.clear(); // nothing is known before a run
  else if (!model.scene.steps[*last].transient) {
    course->set_rates(*state);
    std::fill(state->load_rates.begin(), state->load_rates.end(), 0.);
  }
}

bool TimeMarch::move_to(const double time, const std::function<void()> &after_each) {
  const double tolerance = model.scene.time.tolerance, longest = longest_step;
  unsigned int failures = 0;
  while (state->time < time) {
    const double left = time - state->time;
    const double step = left <= 1.5 * time_step ? left : time_step;
    const double goal = step == left ? time : state->time + step;
    const bool taken = take_time_step(goal);
    if (!taken && report->no_equilibrium)
      return false;
    if (!taken && last_error == not_solved && ++failures == most_failures) {
      report->remark = "stopped at time " + rounded_number(state->time, 6) + ": " + report->remark +
                       ", " + std::to_string(failures) + " times within " +
                       rounded_number(longest) + " s, and that is all there are";
      return false;
    }
    if (!taken && is_shortest(step)) {
      report->remark = "stopped at time " + rounded_number(state->time, 6) + ": " + report->remark +
                       ", also with a time step of " + rounded_number(step) + " s";
      return false;
    }
    if (!taken) {
      ++report->halvings;
      time_step = step / 2.;
      continue;
    }
    std::swap(*state, next);
    ++report->increments;
    if (watchers->of_each)
      watchers->of_each({step_number, report->increments, 0}, *state);
    after_each();
    if (time_step < longest && (tolerance == 0. || last_error < 0.1 * tolerance))
      time_step = std::min(longest, 2. * time_step);
    if (watchers->pause)
      watchers->pause();
  }
  return true;
}

bool TimeMarch::is_shortest(const double step) const {
  return step <=
         longest_step / std::pow(2., model.scene.solver.max_halvings) * (1. + same_instant_of_step);
}

void TimeMarch::pass_jump(const LoadCourse::Factors factors_before) {
  const std::vector<double> rates_before = state->load_rates;
  report->energy += meet_jump(model, *course, *integrator, *state);
  const LoadCourse::Factors jumps =
      course->jumps_between(factors_before, state->load_factors, state->time);
  if (!rates_jump(rates_before, state->load_rates) && !is_any(jumps))
    return;
  state->events.clear(); // they have been shown
  watchers->of_instants({step_number, n_increments, 0, true},
                        state_behind_jump(model, *course, *state));
}

bool TimeMarch::take_time_step(const double time) {
  if (!integrator->is_exact() && jump_met != state->time) {
    jump_met = state->time;
    if (course->jumps(state->time)) {
      course->set_rates(*state, LoadCourse::Side::before);
      pass_jump(state->load_factors);
    }
  }
  last_error = not_solved;
  if (const std::string why = forbidden_jump(model, *course, *state, time); !why.empty()) {
    report->remark = why;
    return false;
  }
  const TimeStep step = integrator->advance(*state, *course, time, next);
  if (!add_result(step.result, *report))
    return false;
  const double tolerance = model.scene.time.tolerance;
  last_error = step.error;
  if (tolerance > 0. && step.error > tolerance && !integrator->is_exact() &&
      !is_shortest(time - state->time))
    return false;
  // A motion that gains is another solution of a step that is too long for its contacts.
  if (model.contacts.size() > 0 && !integrator->is_exact() && !is_shortest(time - state->time) &&
      step.energy.gained() > most_gained * std::max(report->energy.at_hand, step.energy.at_hand) &&
      step.energy.gained() > energy_of_rounding(model, next, time - state->time)) {
    report->remark = "the integrator gains energy";
    return false;
  }
  report->energy += step.energy;
  check_sections(model, next, *report);
  watch_contacts(model, contacts_before, next, *report);
  contacts_before.take(model, next);
  const bool is_whole = watchers->resolution != nullptr;
  if (is_whole && may_share_forces && report->undetermined_forces.empty() &&
      next.contact_status != state->contact_status) {
    report->undetermined_forces = contacts_with_undetermined_forces(model.contacts, next);
    report->undetermined_within = !report->undetermined_forces.empty();
  }
  if (is_whole)
    watchers->resolution->add_time_step(*state, next, integrator->is_exact(), report->resolution);
  report->resolution.handed_over = report->resolution.handed_over || step.handed_over;
  return true;
}

} // namespace frictionbeam
