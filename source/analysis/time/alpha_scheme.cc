// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/alpha_scheme.h"
#include "analysis/contact/solver_library.h"
#include "analysis/increment/time_step.h"
#include "analysis/time/step_helpers.h"

#include "analysis/time/mass_factorization.h"
#include "analysis/time/stiff_friction.h"
#include "base/numbers.h"
#include "model/line_pose.h"

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
      turns(model.cells.turns_far()), has_mass(unknowns_with_mass(model.linear.mass())),
      contacts(model), linearized(model), imposed_inertia(model.scene.loads.size()),
      stiff(model.linear.stiffness()), momentum(model.linear.mass()),
      stiffness_diagonal(model.linear.stiffness().diagonal()) {
  if (!p.impulses)
    return_mapping = make_equilibrium_solver(model.scene.solver, model.contacts, model.space,
                                             model.linear.stiffness());
  if (turns)
    prepare_turning();
  else
    factor_mass(model.linear.mass(), mass);
}

Vector AlphaScheme::contact_forces(const LineState &state) const {
  Vector forces = Vector::Zero(state.unknowns.size());
  if (p.impulses) {
    contacts.take_elastic_forces(state, -1., forces);
    return forces;
  }
  ContactResponse response;
  response.stress = state.contact_stress;
  model.contacts.add_forces(response, forces);
  return forces;
}

std::string AlphaScheme::name() const {
  return model.scene.time.row().word + std::string(turns ? " in corotational kinematics" : "") +
         std::string(p.impulses ? ": rigid contact and friction by impulses on velocities"
                                : ": friction elements by their return mapping");
}

std::string AlphaScheme::warning() const {
  return warn_of_stiff_friction(model, model.scene.time.row().word, !p.impulses);
}

void AlphaScheme::start(LineState &state, const LoadCourse &loads) {
  const LoadCourse::Factors factors = loads.factors_after(state.time);
  Vector forces = (model.cells.is_linear() ? Vector(loads.forces(factors) - stiff(state.unknowns))
                                           : forces_at(state, factors)) -
                  contact_forces(state);
  add_inertia(loads, state.time, LoadCourse::Side::after, forces);
  if (damping().nonZeros() > 0)
    forces -= damping() * state.velocity;
  state.acceleration = accelerations(forces, pose_of(state));
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

AlphaScheme::Step AlphaScheme::begin(const LineState &from, const LoadCourse &loads,
                                     const double time) {
  Step step;
  const double h = step.h = time - from.time;
  step.begin = from.unknowns;
  if (turns)
    set_rotations(model, Vector::Zero(model.space.n_dofs()), step.begin);
  const Vector &a0 = from.auxiliary, &A0 = p.impulses ? at_start.free : from.acceleration;
  step.motion = step.begin + h * from.velocity + h * h * (0.5 - p.beta) * a0;
  if (p.impulses)
    step.motion += h * h * (0.5 - p.beta / p.gamma) * at_start.lasting;
  step.velocity = from.velocity + h * (1. - p.gamma) * a0;
  step.rest = (p.alpha_m * a0 - p.alpha_f * A0) / (1. - p.alpha_f);
  step.factors = loads.factors_before(time);
  step.forces_before = loads.forces(loads.factors_after(from.time));
  step.forces = loads.forces(step.factors);
  add_inertia(loads, from.time, LoadCourse::Side::after, step.forces_before);
  add_inertia(loads, time, LoadCourse::Side::before, step.forces);
  if (turns) {
    step.imposed = loads.imposed(time) - loads.imposed(from.time);
    step.momentum_before = model.space.restrict_forces(
        model.cells.momenta(pose_of(from), model.cells.velocities(from.velocity, from.load_rates)));
  } else {
    step.stiff_before = stiff(from.unknowns);
    step.momentum_before = momentum(from.velocity);
  }
  return step;
}

double AlphaScheme::size_of(const Step &step, const LineState &from) const {
  // Return mapping does not keep what rounding takes from the unknowns.
  const Vector &rounded = p.impulses ? stiffness_diagonal : diagonal;
  return size_of_forces(std::max(largest(step.forces), largest(step.stiff_before)),
                        largest(rounded.cwiseProduct(from.unknowns)) +
                            largest(step.momentum_before) * ratio / (p.beta * step.h),
                        model.scene.solver.tolerance);
}

Vector AlphaScheme::unbalanced(Step &step, const Vector &unknowns, const Vector &low) {
  const SparseMatrix &C = model.linear.damping();
  const double h = step.h;
  step.moved = (unknowns - step.motion) / (p.beta * h * h);
  if (low.size() > 0)
    step.moved += low / (p.beta * h * h);
  Vector inertia;
  multiply(model.linear.mass(), ratio * step.moved + step.rest, inertia);
  Vector left = step.forces - stiff(unknowns) - inertia;
  if (C.nonZeros() > 0)
    left -= C * Vector(step.velocity + p.gamma * h * step.moved);
  return left;
}

EquilibriumResult AlphaScheme::solve(EquilibriumProblem &problem, const Step &step,
                                     const LineState &from, const LoadCourse &loads, LineState &to,
                                     ContactResponse &response) {
  if (!p.impulses)
    return return_mapping->solve(problem, from.contacts, to.unknowns, response);
  const double reach = step.h * p.beta / p.gamma;
  return contacts.solve(problem, from, loads,
                        {step.motion - reach * step.velocity, reach, p.gamma / ratio}, to.unknowns,
                        response);
}

void AlphaScheme::finish_motion(const Step &step, LineState &to) {
  to.velocity = step.velocity + p.gamma * step.h * step.moved;
  to.auxiliary = step.moved;
  if (p.impulses) {
    at_end.time = to.time;
    at_end.by_contacts = Vector::Zero(to.unknowns.size());
    if (!turns) // its contacts are always asked
      at_end.by_contacts = mass.solve(contacts.impulses()) / step.h;
    else if (model.contacts.size() > 0)
      at_end.by_contacts = accelerations(contacts.impulses() / step.h, step.pose);
    to.auxiliary -= at_end.by_contacts / p.gamma;
  }
  to.acceleration = ratio * to.auxiliary + step.rest;
  if (p.impulses) {
    at_end.free = to.acceleration;
    to.acceleration += at_end.by_contacts;
    at_end.lasting = (at_end.by_contacts - (1. - p.gamma) * at_start.lasting) / p.gamma;
  }
  for (int i = 0; i < to.unknowns.size(); ++i)
    if (!has_mass[i]) {
      to.velocity[i] = (to.unknowns[i] - step.begin[i]) / step.h;
      to.acceleration[i] = to.auxiliary[i] = 0.;
    }
  if (!turns)
    return;
  keep_inert(step.pose, (to.unknowns - step.begin) / step.h, to.velocity);
  for (Vector *const rates : {&to.acceleration, &to.auxiliary})
    keep_inert(step.pose, Vector::Zero(to.unknowns.size()), *rates);
  set_pose(model, step.pose, to);
}

TimeStep AlphaScheme::advance(const LineState &from, const LoadCourse &loads, const double time,
                              LineState &to) {
  set_step(time - from.time);
  if (at_end.time == from.time)
    at_start = at_end;
  Step step = begin(from, loads, time);
  EquilibriumProblem problem{{effective, Vector::Constant(1, size_of(step, from))},
                             loads.imposed(time)};
  problem.unbalanced = [&](const Vector &unknowns, const Vector &low) {
    return unbalanced(step, unknowns, low);
  };
  problem.end = time;
  problem.increment = {loads.time_of_laws(time), step.h, model.contacts.temperatures(step.factors)};

  TimeStep report;
  ContactResponse response;
  to.unknowns = from.unknowns;
  take_over_contacts(from, to);
  report.result = model.cells.is_linear() ? solve(problem, step, from, loads, to, response)
                                          : solve_nonlinear(step, from, loads, time, to, response);
  if (!report.result.converged)
    return report;

  arrive(model, loads, time, step.factors, problem.imposed, to);
  finish_motion(step, to);
  commit_contacts(response, from.contact_status, to);
  double jump = 0.; // of the displacements, by impulses
  if (p.impulses) {
    ++report.result.back_substitutions; // in finish_motion()
    jump = step.h * step.h / 2. * largest(at_end.by_contacts - at_start.by_contacts);
    contacts.add_histories(from, step.h, to);
  } else
    add_histories(model.contacts, from, to);
  const std::vector<ContactWork> work = p.impulses ? contacts.work() : std::vector<ContactWork>();
  if (model.cells.is_linear())
    report.energy = account_motion(
        model, from, to,
        {step.stiff_before, stiff(to.unknowns), step.momentum_before, momentum(to.velocity)},
        step.forces_before, step.forces, work);
  else {
    report.energy = account_nonlinear(step, from, loads, to);
    report.energy += account_contacts(model, from, to, work);
  }
  if (p.impulses)
    report.energy += contacts.work_beyond_motion();
  if (to.auxiliary.size() > 0)
    report.error =
        step.h * step.h / 12. * (to.auxiliary - from.auxiliary).lpNorm<Eigen::Infinity>() + jump;
  return report;
}

} // namespace frictionbeam
