// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/analysis/load_sequence.h>

#include <frictionbeam/analysis/line_factorization.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {
constexpr unsigned int most_contacts_for_uniqueness = 100; // the check is quadratic in them
}

LoadSequence::LoadSequence(const Model &model)
    : model(model),
      statics(make_equilibrium_solver(model.scene.solver, model.scene.solver.method, model.contacts,
                                      model.space, model.linear.stiffness())),
      dynamics(make_equilibrium_solver(
          model.scene.solver,
          model.scene.solver.method == SolverSettings::Method::elastic
              ? SolverSettings::Method::elastic
              : SolverSettings::Method::newton, // exact contact is for statics
          model.contacts, model.space, model.linear.stiffness())) {}

EquilibriumProblem LoadSequence::problem(const SparseMatrix &matrix, const Factors &factors) const {
  EquilibriumProblem result{matrix, model.contacts.platen_forces() + model.linear.preload(),
                            Vector::Zero(model.space.n_dofs())};
  for (unsigned int l = 0; l < factors.size(); ++l)
    if (factors[l] != 0.) {
      result.right_hand_side += factors[l] * model.linear.forces(l);
      for (const auto &[dof, value] : model.linear.imposed(l))
        result.imposed[dof] += factors[l] * value;
    }
  return result;
}

void LoadSequence::initialize() {
  const unsigned int n = model.space.n_unknowns();
  current.unknowns = current.velocity = current.acceleration = Vector::Zero(n);
  current.load_factors.assign(model.scene.loads.size(), 0.);
  for (const InitialCondition &initial : model.scene.initial) {
    const unsigned int vertex = model.mesh.points.at(initial.point);
    for (unsigned int c = 0; c < 6; ++c) {
      const auto dof = model.discretization.vertex_dofs().index(vertex, c);
      if (dof != numbers::invalid_dof_index)
        for (const auto &term : model.space.terms(dof)) {
          current.unknowns[term.unknown] = initial.displacement[c];
          current.velocity[term.unknown] = initial.velocity[c];
        }
    }
  }
  model.space.expand(current.unknowns, current.dofs);
  current.contacts = model.contacts.initial_state(current.dofs);
  model.contacts.place_platens(current.unknowns);
  model.space.expand(current.unknowns, current.dofs);
  model.contacts.evaluate(current.dofs, current.contacts, 0., 0., LawTangent::none, response);
  commit(current.load_factors, 0.);
}

void LoadSequence::commit(const Factors &factors, const double time) {
  std::swap(current.contacts, response.state);
  current.contact_stress = response.stress;
  current.contact_status = response.status;
  current.load_factors = factors;
  current.time = time;
}

bool LoadSequence::run(const Observer &observer, const Observer &each) {
  each_increment = each;
  initialize();
  observer({0, 0, 0}, current);
  if (each_increment)
    each_increment({0, 0, 0}, current);
  for (unsigned int step = 0; step < model.scene.steps.size(); ++step) {
    const LoadStep &declared = model.scene.steps[step];
    StepReport report;
    report.step = declared.name;
    step_reports.push_back(report);
    Factors target(model.scene.loads.size(), 0.);
    for (const auto &[load, factor] : declared.loads)
      target[load] += factor;
    step_reports.back().converged = declared.transient ? run_transient(step, target, observer)
                                                       : run_static(step, target, observer);
    if (!step_reports.back().converged)
      return false;
  }
  return true;
}

bool LoadSequence::run_static(const unsigned int step, const Factors &target,
                              const Observer &observer) {
  const LoadStep &declared = model.scene.steps[step];
  const Factors from = current.load_factors;
  const double start = current.time;
  current.velocity.setZero();
  current.acceleration.setZero();
  for (unsigned int i = 1; i <= declared.n_increments; ++i) {
    const double part = static_cast<double>(i) / declared.n_increments;
    Factors to(target.size());
    for (unsigned int l = 0; l < to.size(); ++l)
      to[l] = i == declared.n_increments ? target[l] : from[l] + part * (target[l] - from[l]);
    if (!advance(Factors(current.load_factors), to, start + part * declared.duration, false, 0))
      return false;
    observer({step, i, declared.n_increments}, current);
  }
  if (model.contacts.size() <= most_contacts_for_uniqueness)
    step_reports.back().several_equilibria = statics->beyond_uniqueness(current.contact_status);
  return true;
}

bool LoadSequence::run_transient(const unsigned int step, const Factors &target,
                                 const Observer &observer) {
  const LoadStep &declared = model.scene.steps[step];
  const unsigned int n = std::max(1., std::ceil(declared.duration / model.scene.time.step - 1e-9));
  const Factors from = current.load_factors;
  const double start = current.time;
  const auto factors_at = [&](const double time) {
    const double part = declared.ramp > 0. ? std::min(1., (time - start) / declared.ramp) : 1.;
    Factors factors(target.size());
    for (unsigned int l = 0; l < factors.size(); ++l)
      factors[l] = part == 1. ? target[l] : from[l] + part * (target[l] - from[l]);
    return factors;
  };
  current.load_factors = factors_at(start);
  start_motion();
  for (unsigned int i = 1; i <= n; ++i) {
    const double time = start + declared.duration * i / n;
    if (!advance(Factors(current.load_factors), factors_at(time), time, true, 0))
      return false;
    observer({step, i, n}, current);
  }
  return true;
}

/// Accelerations that are in equilibrium with the forces at the start of a motion.
void LoadSequence::start_motion() {
  const EquilibriumProblem start = problem(model.linear.stiffness(), current.load_factors);
  Vector forces = start.right_hand_side - model.linear.stiffness() * current.unknowns;
  model.contacts.evaluate(current.dofs, current.contacts, current.time, 0., LawTangent::none,
                          response);
  Vector contact_forces = Vector::Zero(forces.size());
  model.contacts.add_forces(response, contact_forces);
  forces -= contact_forces;
  SparseMatrix mass = model.linear.mass();
  for (int i = 0; i < mass.rows(); ++i)
    if (mass.coeff(i, i) == 0.) { // a platen, a node without mass: moves with its forces balanced
      mass.coeffRef(i, i) = 1.;
      forces[i] = 0.;
    }
  LineFactorization factors;
  factors.analyze(mass);
  const bool regular = factors.factorize(mass);
  AssertThrow(regular, ExcMessage("The mass matrix is singular."));
  current.acceleration = factors.solve(forces);
}

bool LoadSequence::advance(const Factors &from, const Factors &to, const double time,
                           const bool transient, const unsigned int halvings) {
  StepReport &report = step_reports.back();
  const double start = current.time;
  if (solve_increment(to, time, transient)) {
    ++report.increments;
    if (each_increment)
      each_increment({static_cast<unsigned int>(step_reports.size() - 1), report.increments, 0},
                     current);
    return true;
  }
  if (report.no_equilibrium) {
    report.remark = "stopped at time " + std::to_string(start) + ": " + report.remark;
    return false;
  }
  if (halvings == model.scene.solver.max_halvings) {
    report.remark = "stopped at time " + std::to_string(start) + ": " + report.remark +
                    ", also after halving the increment " + std::to_string(halvings) + " times";
    return false;
  }
  ++report.halvings;
  Factors middle(to.size());
  for (unsigned int l = 0; l < to.size(); ++l)
    middle[l] = (from[l] + to[l]) / 2.;
  return advance(from, middle, (start + time) / 2., transient, halvings + 1) &&
         advance(middle, to, time, transient, halvings + 1);
}

bool LoadSequence::report(const EquilibriumResult &result) {
  StepReport &report = step_reports.back();
  report.iterations += result.iterations;
  report.factorizations += result.factorizations;
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

bool LoadSequence::solve_increment(const Factors &factors, const double time,
                                   const bool transient) {
  if (transient)
    return solve_newmark(problem(effective, factors), time) && (commit(factors, time), true);

  EquilibriumProblem increment = problem(model.linear.stiffness(), factors);
  increment.time = time;
  trial = current.unknowns;
  if (!report(statics->solve(increment, current.contacts, trial, response)))
    return false;
  const Vector loads_before =
      problem(model.linear.stiffness(), current.load_factors).right_hand_side;
  LineState before = current;
  current.unknowns = trial;
  model.space.expand(current.unknowns, current.dofs);
  current.dofs += increment.imposed;
  commit(factors, time);
  step_reports.back().energy +=
      account_increment(model, before, current, loads_before, increment.right_hand_side);
  return true;
}

/// Newmark's method: M a + K q + contact forces = f at the end of the time step, with
/// q = q0 + dt v0 + dt^2 ((1/2 - beta) a0 + beta a), v = v0 + dt ((1 - gamma) a0 + gamma a).
bool LoadSequence::solve_newmark(const EquilibriumProblem &forces, const double time) {
  const double dt = time - current.time;
  const double beta = model.scene.time.beta, gamma = model.scene.time.gamma;
  if (std::abs(dt - effective_step) > 1e-9 * dt) {
    effective = model.linear.stiffness() + 1. / (beta * dt * dt) * model.linear.mass();
    effective_step = dt;
    dynamics->matrix_changed();
  }
  const Vector predicted =
      current.unknowns + dt * current.velocity + dt * dt * (0.5 - beta) * current.acceleration;
  EquilibriumProblem increment = forces;
  increment.right_hand_side += model.linear.mass() * predicted / (beta * dt * dt);
  increment.time = time;
  increment.time_increment = dt;
  trial = current.unknowns;
  if (!report(dynamics->solve(increment, current.contacts, trial, response)))
    return false;
  const Vector acceleration = (trial - predicted) / (beta * dt * dt);
  current.velocity += dt * ((1. - gamma) * current.acceleration + gamma * acceleration);
  current.acceleration = acceleration;
  current.unknowns = trial;
  model.space.expand(current.unknowns, current.dofs);
  current.dofs += increment.imposed;
  return true;
}

} // namespace frictionbeam
