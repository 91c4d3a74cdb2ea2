// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/analysis/load_sequence.h>

#include "corotational_statics.h"
#include "load_jumps.h"
#include "time_instants.h"
#include "follow_resolution.h"
#include "transient_reduction.h"

#include <frictionbeam/analysis/contact_watch.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {
constexpr double not_solved = -1.;          ///< in place of a time step's error
constexpr unsigned int most_failures = 200; ///< of time steps from one instant to the next
} // namespace

LoadSequence::LoadSequence(const Model &model)
    : model(model),
      statics(make_equilibrium_solver(model.scene.solver, model.scene.solver.method, model.contacts,
                                      model.space, model.linear.stiffness())),
      corotational_statics(model.corotational ? std::make_unique<CorotationalStatics>(model)
                                              : nullptr),
      course(model), declared(model.scene.loads.size(), 0.) {}

LoadSequence::~LoadSequence() = default;

std::string LoadSequence::integrator_name() const {
  return integrator ? integrator->name() : reduction ? reduction->integrator_name() : "";
}

void LoadSequence::initialize() {
  check_time_steps(model);
  const unsigned int n = model.space.n_unknowns();
  current.unknowns = current.velocity = current.acceleration = current.auxiliary = Vector::Zero(n);
  current.load_factors = declared;
  if (model.corotational)
    current.turns = model.corotational->at_rest().turns;
  set_initial_motion(true);
  const Vector imposed = course.imposed(0.);
  const auto expand = [&]() {
    model.space.expand(current.unknowns, current.dofs);
    current.dofs += imposed;
  };
  expand();
  current.contacts = model.contacts.initial_state(current.dofs);
  model.contacts.place_platens(current.unknowns);
  expand();
  model.contacts.evaluate(current.dofs, current.contacts, 0., 0., LawTangent::none, response);
  commit(declared, 0.);
}

void LoadSequence::commit(const Factors &factors, const double time) {
  response.state.wear = current.contacts.wear;
  response.state.impulse = current.contacts.impulse;
  const LineState before = current;
  current.time = time;
  declared = factors;
  current.load_factors = course.factors_at(time, side);
  commit_contacts(response, before, current);
}

bool LoadSequence::run(const Observer &observer, const Observer &each, const Pause &pause,
                       const NeedsLine &needs_line) {
  each_increment = each;
  between_increments = pause;
  observer_needs_line = needs_line;
  if (!resolution)
    resolution = std::make_unique<FollowResolution>(model);
  if (!is_resumed) {
    initialize();
    observer({0, 0, 0}, current);
    if (each_increment)
      each_increment({0, 0, 0}, current);
  }
  for (; position.step < model.scene.steps.size(); ++position.step) {
    const LoadStep &declared_step = model.scene.steps[position.step];
    if (!is_resumed) {
      StepReport report;
      report.step = declared_step.name;
      step_reports.push_back(report);
      position.from = declared;
      position.start = current.time;
      position.next = position.increment = 0;
    }
    Factors target(model.scene.loads.size(), 0.);
    for (const auto &[load, factor] : declared_step.loads)
      target[load] += factor;
    const auto steps = model.scene.steps.begin();
    if (declared_step.transient && !is_resumed &&
        std::none_of(steps, steps + position.step,
                     [](const LoadStep &step) { return step.transient; }))
      set_initial_motion(false);
    // A step within which the run was cut was not reduced.
    const bool reduced =
        model.scene.time.reduction.modes != ReductionSettings::Modes::all && !is_resumed;
    step_reports.back().converged = !declared_step.transient ? run_static(target, observer)
                                    : reduced                ? run_reduced(target, observer)
                                                             : run_transient(target, observer);
    if (!step_reports.back().converged)
      return false;
  }
  return true;
}

void LoadSequence::transfer(Archive &archive) {
  bool has_integrator = integrator != nullptr;
  if (!resolution)
    resolution = std::make_unique<FollowResolution>(model);
  archive(position, declared, current, step_reports, time_step, last_error, force_so_far,
          in_equilibrium, *statics, *resolution, has_integrator);
  if (archive.reads() && has_integrator)
    integrator = make_time_integrator(model, piece_observer);
  if (has_integrator)
    archive(*integrator);
  if (archive.reads())
    is_resumed = true;
}

bool LoadSequence::run_transient(const Factors &target, const Observer &observer) {
  const unsigned int step = position.step;
  const LoadStep &declared_step = model.scene.steps[step];
  if (!integrator)
    integrator = make_time_integrator(model, piece_observer);
  longest_step = frictionbeam::time_step(model);
  const double start = position.start, end = start + declared_step.duration;
  course.begin_step(step, position.from, target, start, declared_step.ramp);
  const std::vector<double> times = integrator->is_exact()
                                        ? instants_of_output(model, start, end, longest_step)
                                        : instants_of_steps(course, start, end, longest_step);
  if (!is_resumed) {
    declared = course.declared(start);
    current.load_factors = course.factors_after(start);
    course.set_rates(current, LoadCourse::Side::after);
    integrator->start(current, course);
    time_step = longest_step;
    jump_met = start;
  }
  is_resumed = in_equilibrium = false;
  for (std::size_t &i = position.next; i < times.size(); ++i) {
    const auto observe = [&]() {
      const unsigned int increment = ++position.increment;
      const bool last = current.time == end;
      const std::size_t left = times.size() - i;
      observer({step, increment, last ? increment : increment + static_cast<unsigned int>(left)},
               current);
    };
    if (!move_to(times[i], observe))
      return false;
  }
  step_reports.back().remark = integrator->remark();
  step_reports.back().warning = integrator->warning();
  return true;
}

bool LoadSequence::run_reduced(const Factors &target, const Observer &observer) {
  if (!reduction)
    reduction = std::make_unique<TransientReduction>(model);
  StepReport &report = step_reports.back();
  report.reduction.emplace();
  const TransientReduction::Start start{position.step, position.from, target};
  if (!reduction->prepare(start, current, *report.reduction))
    return run_transient(target, observer);
  course.begin_step(position.step, position.from, target, position.start,
                    model.scene.steps[position.step].ramp);
  in_equilibrium = false;
  const bool done = reduction->run(start, course, current, report,
                                   {observer, observer_needs_line, piece_observer});
  declared = course.declared(current.time);
  return done;
}

bool LoadSequence::run_transient_alone(const unsigned int step, const LineState &start,
                                       const Factors &before, const Factors &target,
                                       const Observer &observer) {
  StepReport report;
  report.step = model.scene.steps[step].name;
  step_reports.push_back(report);
  current = start;
  declared = before;
  position = {step, before, start.time, 0, 0};
  step_reports.back().converged = run_transient(target, observer);
  return step_reports.back().converged;
}

bool LoadSequence::move_to(const double time, const std::function<void()> &after_each) {
  const double tolerance = model.scene.time.tolerance, longest = longest_step,
               least = longest / std::pow(2., model.scene.solver.max_halvings);
  StepReport &report = step_reports.back();
  unsigned int failures = 0;
  while (current.time < time) {
    const double left = time - current.time;
    const double step = left <= 1.5 * time_step ? left : time_step;
    const double goal = step == left ? time : current.time + step;
    const bool taken = take_time_step(goal);
    if (!taken && report.no_equilibrium)
      return false;
    if (!taken && last_error == not_solved && ++failures == most_failures) {
      report.remark = "stopped at time " + std::to_string(current.time) + ": " + report.remark +
                      ", " + std::to_string(failures) + " times within " + std::to_string(longest) +
                      " s, and that is all there are";
      return false;
    }
    if (!taken && step <= least * (1. + 1e-9)) {
      report.remark = "stopped at time " + std::to_string(current.time) + ": " + report.remark +
                      ", also with a time step of " + std::to_string(step) + " s";
      return false;
    }
    if (!taken) {
      ++report.halvings;
      time_step = step / 2.;
      continue;
    }
    std::swap(current, next);
    ++report.increments;
    if (each_increment)
      each_increment({static_cast<unsigned int>(step_reports.size() - 1), report.increments, 0},
                     current);
    after_each();
    if (time_step < longest && (tolerance == 0. || last_error < 0.1 * tolerance))
      time_step = std::min(longest, 2. * time_step);
    if (between_increments)
      between_increments();
  }
  return true;
}

bool LoadSequence::take_time_step(const double time) {
  if (!integrator->is_exact() && jump_met != current.time) {
    jump_met = current.time;
    if (course.jumps(current.time))
      step_reports.back().energy += meet_jump(model, course, *integrator, current);
  }
  const TimeStep step = integrator->advance(current, course, time, next);
  last_error = not_solved;
  if (!report(step.result))
    return false;
  const double tolerance = model.scene.time.tolerance,
               least = longest_step / std::pow(2., model.scene.solver.max_halvings);
  last_error = step.error;
  if (tolerance > 0. && step.error > tolerance && !integrator->is_exact() &&
      time - current.time > least * (1. + 1e-9))
    return false;
  declared = course.declared(next.time);
  step_reports.back().energy += step.energy;
  watch_contacts(model, current, next, step_reports.back());
  if (resolution)
    resolution->add_time_step(current, next, integrator->is_exact(),
                              step_reports.back().resolution);
  return true;
}

bool LoadSequence::report(const EquilibriumResult &result) {
  StepReport &report = step_reports.back();
  report.iterations += result.iterations;
  report.factorizations += result.factorizations;
  report.back_substitutions += result.back_substitutions;
  if (!result.converged) {
    report.remark = result.remark;
    report.no_equilibrium = result.no_equilibrium;
    return false;
  }
  report.residual = std::max(report.residual, result.residual);
  if (result.check)
    report.contact.include(*result.check);
  return true;
}

} // namespace frictionbeam
