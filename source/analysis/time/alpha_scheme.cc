// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/alpha_scheme.h"
#include "analysis/contact/solver_library.h"
#include "analysis/increment/time_step.h"
#include "analysis/time/step_helpers.h"

#include "analysis/time/mass_factorization.h"
#include "analysis/time/stiff_friction.h"
#include "base/numbers.h"

namespace frictionbeam {

using namespace dealii;

AlphaScheme::Parameters AlphaScheme::newmark(const Scene &scene) {
  return {0., 0., scene.time.beta, scene.time.gamma, scene.solver.is_exact()};
}

AlphaScheme::Parameters AlphaScheme::generalized_alpha(const Scene &scene) {
  const double rho = scene.time.spectral_radius;
  Parameters result;
  result.alpha_m = (2. * rho - 1.) / (rho + 1.);
  result.alpha_f = rho / (rho + 1.);
  result.gamma = 0.5 + result.alpha_f - result.alpha_m;
  result.beta = 0.25 * (result.gamma + 0.5) * (result.gamma + 0.5);
  result.impulses = scene.solver.is_exact();
  return result;
}

AlphaScheme::Parameters AlphaScheme::nonsmooth(const Scene &scene) {
  Parameters result = generalized_alpha(scene);
  result.impulses = true;
  return result;
}

AlphaScheme::AlphaScheme(const Model &model, const Parameters &parameters)
    : model(model), p(parameters), ratio((1. - p.alpha_m) / (1. - p.alpha_f)),
      has_mass(unknowns_with_mass(model.linear.mass())), contacts(model),
      stiff(model.linear.stiffness()), momentum(model.linear.mass()),
      stiffness_diagonal(model.linear.stiffness().diagonal()) {
  if (!p.impulses)
    return_mapping = make_equilibrium_solver(model.scene.solver, model.contacts, model.space,
                                             model.linear.stiffness());
  factor_mass(model.linear.mass(), mass);
}

Vector AlphaScheme::contact_forces(const LineState &state) const {
  if (p.impulses)
    return contacts.elastic_forces(state);
  ContactResponse response;
  response.stress = state.contact_stress;
  Vector forces = Vector::Zero(state.unknowns.size());
  model.contacts.add_forces(response, forces);
  return forces;
}

std::string AlphaScheme::name() const {
  return model.scene.time.row().word +
         std::string(p.impulses ? ": rigid contact and friction by impulses on velocities"
                                : ": friction elements by their return mapping");
}

std::string AlphaScheme::warning() const {
  return warn_of_stiff_friction(model, model.scene.time.row().word, !p.impulses);
}

void AlphaScheme::start(LineState &state, const LoadCourse &loads) {
  Vector forces = loads.forces(loads.factors_after(state.time)) -
                  model.linear.stiffness() * state.unknowns - contact_forces(state);
  loads.add_inertia(state.time, forces, LoadCourse::Side::after);
  if (model.linear.damping().nonZeros() > 0)
    forces -= model.linear.damping() * state.velocity;
  for (int i = 0; i < forces.size(); ++i)
    if (!has_mass[i]) // a platen, a node without mass: moves with its forces balanced
      forces[i] = 0.;
  state.acceleration = mass.solve(forces);
  state.auxiliary = state.acceleration;
  if (!p.impulses)
    return;
  at_end.time = state.time;
  at_end.free = state.acceleration;
  at_end.lasting = at_end.by_contacts = -mass.solve(contacts.rigid_forces(state));
  state.acceleration += at_end.lasting;
}

void AlphaScheme::set_step(const double step) {
  if (std::abs(step - effective_step) <= same_instant_of_step * step)
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
    archive(contacts, at_start, at_end);
  else
    return_mapping->transfer(archive);
}

TimeStep AlphaScheme::advance(const LineState &from, const LoadCourse &loads, const double time,
                              LineState &to) {
  const double h = time - from.time, beta = p.beta, gamma = p.gamma;
  set_step(h);
  const SparseMatrix &M = model.linear.mass(), &C = model.linear.damping();
  if (at_end.time == from.time)
    at_start = at_end;
  const Vector &a0 = from.auxiliary, &A0 = p.impulses ? at_start.free : from.acceleration;
  Vector q = from.unknowns + h * from.velocity + h * h * (0.5 - beta) * a0;
  if (p.impulses)
    q += h * h * (0.5 - beta / gamma) * at_start.lasting;
  const Vector v = from.velocity + h * (1. - gamma) * a0,
               rest = (p.alpha_m * a0 - p.alpha_f * A0) / (1. - p.alpha_f);
  const LoadCourse::Factors factors = loads.factors_before(time);
  Vector forces_before = loads.forces(loads.factors_after(from.time)),
         forces = loads.forces(factors);
  loads.add_inertia(from.time, forces_before, LoadCourse::Side::after);
  loads.add_inertia(time, forces, LoadCourse::Side::before);
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
  problem.increment = {time, h, model.contacts.temperatures(factors)};

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
    at_end.time = time;
    at_end.by_contacts = mass.solve(contacts.impulses()) / h;
    ++step.result.back_substitutions;
    to.auxiliary -= at_end.by_contacts / gamma;
    jump = h * h / 2. * largest(at_end.by_contacts - at_start.by_contacts);
  }
  to.acceleration = ratio * to.auxiliary + rest;
  if (p.impulses) {
    at_end.free = to.acceleration;
    to.acceleration += at_end.by_contacts;
    at_end.lasting = (at_end.by_contacts - (1. - gamma) * at_start.lasting) / gamma;
  }
  for (int i = 0; i < to.unknowns.size(); ++i)
    if (!has_mass[i]) {
      to.velocity[i] = (to.unknowns[i] - from.unknowns[i]) / h;
      to.acceleration[i] = to.auxiliary[i] = 0.;
    }
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += problem.imposed;
  to.time = time;
  to.load_factors = factors;
  loads.set_rates(to, LoadCourse::Side::before);
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
