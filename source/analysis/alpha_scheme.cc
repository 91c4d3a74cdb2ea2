// SPDX-License-Identifier: LGPL-2.1-or-later
#include "alpha_scheme.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

AlphaScheme::Parameters AlphaScheme::newmark(const TimeSettings &settings) {
  return {0.,
          0.,
          settings.beta,
          settings.gamma,
          false,
          "newmark: friction elements by their return mapping"};
}

AlphaScheme::Parameters AlphaScheme::generalized_alpha(const TimeSettings &settings) {
  const double rho = settings.spectral_radius;
  Parameters result;
  result.alpha_m = (2. * rho - 1.) / (rho + 1.);
  result.alpha_f = rho / (rho + 1.);
  result.gamma = 0.5 + result.alpha_f - result.alpha_m;
  result.beta = 0.25 * (result.gamma + 0.5) * (result.gamma + 0.5);
  result.name = "generalized_alpha: friction elements by their return mapping";
  return result;
}

AlphaScheme::Parameters AlphaScheme::nonsmooth(const TimeSettings &settings) {
  Parameters result = generalized_alpha(settings);
  result.impulses = true;
  result.name = "nonsmooth_alpha: rigid contact and friction by impulses on velocities";
  return result;
}

AlphaScheme::AlphaScheme(const Model &model, const Parameters &parameters)
    : model(model), p(parameters), ratio((1. - p.alpha_m) / (1. - p.alpha_f)),
      has_mass(unknowns_with_mass(model.linear.mass())), contacts(model),
      stiff(model.linear.stiffness()), momentum(model.linear.mass()),
      stiffness_diagonal(model.linear.stiffness().diagonal()) {
  if (!p.impulses)
    return_mapping =
        make_equilibrium_solver(model.scene.solver,
                                model.scene.solver.method == SolverSettings::Method::elastic
                                    ? SolverSettings::Method::elastic
                                    : SolverSettings::Method::newton,
                                model.contacts, model.space, model.linear.stiffness());
  const SparseMatrix regular = regular_mass(model.linear.mass());
  mass.analyze(regular);
  const bool is_regular = mass.factorize(regular);
  AssertThrow(is_regular, ExcMessage("The mass matrix is singular."));
}

Vector AlphaScheme::contact_forces(const LineState &state) const {
  if (p.impulses)
    return contacts.elastic_forces(state);
  ContactResponse response;
  model.contacts.evaluate(state.dofs, state.contacts, state.time, 0., LawTangent::none, response);
  Vector forces = Vector::Zero(state.unknowns.size());
  model.contacts.add_forces(response, forces);
  return forces;
}

void AlphaScheme::start(LineState &state, const LoadCourse &loads) {
  Vector forces =
      loads.forces(state.time) - model.linear.stiffness() * state.unknowns - contact_forces(state);
  loads.add_inertia(state.time, forces);
  if (model.linear.damping().nonZeros() > 0)
    forces -= model.linear.damping() * state.velocity;
  for (int i = 0; i < forces.size(); ++i)
    if (!has_mass[i]) // a platen, a node without mass: moves with its forces balanced
      forces[i] = 0.;
  state.acceleration = mass.solve(forces);
  state.auxiliary = state.acceleration;
}

void AlphaScheme::set_step(const double step) {
  if (std::abs(step - effective_step) <= 1e-9 * step)
    return;
  effective = model.linear.stiffness() + ratio / (p.beta * step * step) * model.linear.mass();
  if (model.linear.damping().nonZeros() > 0)
    effective = effective + p.gamma / (p.beta * step) * model.linear.damping();
  diagonal = effective.diagonal();
  effective_step = step;
  if (p.impulses)
    contacts.set_matrix(effective);
  else
    return_mapping->matrix_changed();
}

void AlphaScheme::transfer(Archive &archive) {
  double step = effective_step;
  archive(step);
  if (archive.reads() && step > 0.)
    set_step(step);
  if (p.impulses)
    contacts.transfer(archive);
  else
    return_mapping->transfer(archive);
}

TimeStep AlphaScheme::advance(const LineState &from, const LoadCourse &loads, const double time,
                              LineState &to) {
  const double h = time - from.time, beta = p.beta, gamma = p.gamma;
  set_step(h);
  const SparseMatrix &M = model.linear.mass(), &C = model.linear.damping();
  const Vector &a0 = from.auxiliary;
  const Vector q = from.unknowns + h * from.velocity + h * h * (0.5 - beta) * a0,
               v = from.velocity + h * (1. - gamma) * a0,
               rest = (p.alpha_m * a0 - p.alpha_f * from.acceleration) / (1. - p.alpha_f);
  Vector forces_before = loads.forces(from.time), forces = loads.forces(time);
  loads.add_inertia(from.time, forces_before);
  loads.add_inertia(time, forces);
  Vector moved; // a1
  const Vector stiff_before = stiff(from.unknowns), momentum_before = momentum(from.velocity);
  // Return mapping does not keep what rounding takes from the unknowns.
  const Vector &rounded = p.impulses ? stiffness_diagonal : diagonal;
  const double size = size_of_forces(std::max(largest(forces), largest(stiff_before)),
                                     largest(rounded.cwiseProduct(from.unknowns)) +
                                         largest(momentum_before) * ratio / (beta * h),
                                     model.scene.solver.tolerance);
  EquilibriumProblem problem{effective, Vector::Constant(1, size), loads.imposed(time)};
  problem.unbalanced = [&](const Vector &unknowns, const Vector &low) -> Vector {
    moved = (unknowns - q) / (beta * h * h);
    if (low.size() > 0)
      moved += low / (beta * h * h);
    Vector left = forces - stiff(unknowns) - M * Vector(ratio * moved + rest);
    if (C.nonZeros() > 0)
      left -= C * Vector(v + gamma * h * moved);
    return left;
  };
  problem.time = time;
  problem.time_increment = h;

  TimeStep step;
  ContactResponse response;
  to.unknowns = from.unknowns;
  take_over_contacts(from, to);
  if (p.impulses) {
    const double reach = h * beta / gamma;
    step.result =
        contacts.solve(problem, from, loads.imposed(from.time),
                       {q - reach * v, reach, gamma / ratio, loads.may_jump(from.time, time)},
                       to.unknowns, response);
  } else
    step.result = return_mapping->solve(problem, from.contacts, to.unknowns, response);
  if (!step.result.converged)
    return step;

  to.velocity = v + gamma * h * moved;
  to.auxiliary = moved;
  double jump = 0.;
  if (p.impulses) {
    const Vector w = mass.solve(contacts.impulses());
    ++step.result.back_substitutions;
    to.auxiliary -= w / (h * gamma);
    jump = w.size() > 0 ? h * w.lpNorm<Eigen::Infinity>() / 2. : 0.;
  }
  to.acceleration = ratio * to.auxiliary + rest;
  for (int i = 0; i < to.unknowns.size(); ++i)
    if (!has_mass[i]) {
      to.velocity[i] = (to.unknowns[i] - from.unknowns[i]) / h;
      to.acceleration[i] = to.auxiliary[i] = 0.;
    }
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += problem.imposed;
  to.time = time;
  to.load_factors = loads.factors(time);
  loads.set_rates(to);
  commit_contacts(response, from, to);
  if (p.impulses)
    contacts.add_histories(from, h, to);
  else
    add_histories(model.contacts, from, to);
  step.energy = account_motion(
      model, from, to, {stiff_before, stiff(to.unknowns), momentum_before, momentum(to.velocity)},
      forces_before, forces, p.impulses ? contacts.work() : std::vector<ContactWork>());
  if (to.auxiliary.size() > 0)
    step.error = h * h / 12. * (to.auxiliary - a0).lpNorm<Eigen::Infinity>() + jump;
  return step;
}

} // namespace frictionbeam
