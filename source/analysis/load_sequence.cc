// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/analysis/load_sequence.h>

#include "corotational_statics.h"
#include "follow_resolution.h"
#include "transient_reduction.h"

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

void LoadSequence::set_initial_motion(const bool displaced) {
  const VertexDofs &dofs = model.discretization.vertex_dofs();
  for (const InitialCondition &initial : model.scene.initial) {
    std::vector<unsigned int> vertices;
    for (const std::string &point : initial.points)
      vertices.push_back(model.mesh.points.at(point));
    for (unsigned int p = 0; p < model.mesh.pipes.size(); ++p)
      if (std::count(initial.pipes.begin(), initial.pipes.end(), model.scene.pipes[p].name) > 0)
        vertices.insert(vertices.end(), model.mesh.pipes[p].vertices.begin(),
                        model.mesh.pipes[p].vertices.end());
    const auto at = [&](Motion motion, const unsigned int vertex) {
      if (initial.about.empty())
        return motion;
      const Vector3 arm =
          model.mesh.vertices[vertex] - model.mesh.vertices[model.mesh.points.at(initial.about)];
      const Vector3 turned = cross_product_3d(Vector3({motion[3], motion[4], motion[5]}), arm);
      for (unsigned int d = 0; d < 3; ++d)
        motion[d] += turned[d];
      return motion;
    };
    for (const unsigned int vertex : vertices) {
      const Motion displacement = at(initial.displacement, vertex),
                   velocity = at(initial.velocity, vertex);
      for (unsigned int c = 0; c < 6; ++c)
        if (const auto dof = dofs.index(vertex, c); dof != numbers::invalid_dof_index)
          for (const auto &term : model.space.terms(dof)) {
            if (displaced)
              current.unknowns[term.unknown] = displacement[c];
            current.velocity[term.unknown] = velocity[c];
          }
    }
  }
}

void LoadSequence::initialize() {
  check_time_steps(model);
  const unsigned int n = model.space.n_unknowns();
  current.unknowns = current.velocity = current.acceleration = current.auxiliary = Vector::Zero(n);
  current.load_factors = declared;
  if (model.corotational)
    current.turns = model.corotational->at_rest().turns;
  set_initial_motion(true);
  const auto expand = [&]() {
    model.space.expand(current.unknowns, current.dofs);
    model.contacts.add_ground_motion(0., current.dofs);
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
  current.load_factors = course.factors(time);
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
    integrator = make_time_integrator(model);
  if (has_integrator)
    archive(*integrator);
  if (archive.reads())
    is_resumed = true;
}

std::vector<double> LoadSequence::instants(const double start, const double end) const {
  const double step = longest_step;
  const unsigned int n = std::max(1., std::ceil((end - start) / step - 1e-9));
  std::vector<double> result;
  for (unsigned int i = 1; i <= n; ++i)
    result.push_back(i == n ? end : start + (end - start) * i / n);
  if (!integrator->is_exact())
    return result;
  for (const Quantity &quantity : model.scene.quantities)
    if (quantity.time && *quantity.time > start && *quantity.time < end)
      result.push_back(*quantity.time);
  std::sort(result.begin(), result.end());
  const double least = 1e-9 * step;
  std::vector<double> apart;
  for (const double instant : result) // of two that are next to one, the later
    if (!apart.empty() && instant - apart.back() < least)
      apart.back() = instant;
    else
      apart.push_back(instant);
  return apart;
}

bool LoadSequence::run_transient(const Factors &target, const Observer &observer) {
  const unsigned int step = position.step;
  const LoadStep &declared_step = model.scene.steps[step];
  if (!integrator)
    integrator = make_time_integrator(model);
  longest_step = frictionbeam::time_step(model);
  const double start = position.start, end = start + declared_step.duration;
  course.begin_step(position.from, target, start, declared_step.ramp);
  const std::vector<double> times = instants(start, end);
  if (!is_resumed) {
    declared = course.declared(start);
    current.load_factors = course.factors(start);
    course.set_rates(current);
    integrator->start(current, course);
    time_step = integrator->is_exact() ? longest_step : times.front() - start;
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
  course.begin_step(position.from, target, position.start, model.scene.steps[position.step].ramp);
  in_equilibrium = false;
  const bool done = reduction->run(start, course, current, report, observer, observer_needs_line);
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
