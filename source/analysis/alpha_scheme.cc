// SPDX-License-Identifier: LGPL-2.1-or-later
#include "alpha_scheme.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {
/// (h omega)^2 of the swing in a friction element's shear beyond which steps do not follow it.
constexpr double most_stiff_shear = 4.;
} // namespace

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
  response.stress = state.contact_stress;
  Vector forces = Vector::Zero(state.unknowns.size());
  model.contacts.add_forces(response, forces);
  return forces;
}

void AlphaScheme::settle(LineState &state, const Vector &imposed) const {
  ContactState committed = state.contacts;
  bool differs = false;
  ContactResponse response;
  model.contacts.prepare(response);
  response.state.strain = state.contacts.strain;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (contact.law->threshold == nullptr || state.contact_status[i] == ContactStatus::open)
      continue;
    FrictionThreshold law{};
    contact.law->threshold(contact.parameters->data(), law);
    const Contact::Strains &stress = state.contact_stress[i];
    model.contacts.evaluate_law(i, state.contacts, state.time, 0., LawTangent::elastic, response);
    if ((response.stress[i] - stress).norm() <= 1e-6 * stress.norm())
      continue;
    differs = true;
    if (std::isinf(law.shear_rigidity_y)) // the elastic shear that carries the friction
      for (const auto &[e, place] : {std::pair(1, law.slip_y), std::pair(2, law.slip_z)})
        committed.internal[contact.state_offset + place] =
            state.contacts.strain[i][e] - stress[e] / response.tangent[i](e, e);
  }
  if (!differs)
    return;
  const Vector forces = model.linear.stiffness() * state.unknowns + contact_forces(state);
  EquilibriumProblem problem{model.linear.stiffness(), forces, imposed};
  problem.time = state.time;
  Vector unknowns = state.unknowns;
  const auto solver =
      make_equilibrium_solver(model.scene.solver, SolverSettings::Method::newton, model.contacts,
                              model.space, model.linear.stiffness());
  if (!solver->solve(problem, committed, unknowns, response).converged)
    return; // the motion begins with what the elements make of the displacements
  state.unknowns = unknowns;
  model.space.expand(state.unknowns, state.dofs);
  state.dofs += imposed;
  response.state.wear = state.contacts.wear;
  response.state.impulse = state.contacts.impulse;
  response.state.dissipated = state.contacts.dissipated;
  std::swap(state.contacts, response.state);
  state.contact_stress = response.stress;
  state.contact_status = response.status;
}

std::string AlphaScheme::warning() const {
  if (p.impulses)
    return "";
  const double h = time_step(model);
  std::vector<unsigned int> supports;
  ContactResponse response;
  model.contacts.prepare(response);
  const ContactState at_rest = model.contacts.initial_state(Vector::Zero(model.space.n_dofs()));
  response.state.strain = at_rest.strain;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (contact.law->threshold == nullptr ||
        std::count(supports.begin(), supports.end(), contact.support) > 0)
      continue;
    FrictionThreshold law{};
    contact.law->threshold(contact.parameters->data(), law);
    model.contacts.evaluate_law(i, at_rest, 0., 0., LawTangent::elastic, response);
    for (unsigned int j = 0; j < contact.unknowns.size() && law.static_friction > 0.; ++j) {
      const double b = contact.B_reduced.col(j).segment<2>(1).squaredNorm(),
                   m = model.linear.mass().coeff(contact.unknowns[j], contact.unknowns[j]);
      if (m > 0. && contact.weight * response.tangent[i](1, 1) * b * h * h > most_stiff_shear * m) {
        supports.push_back(contact.support);
        break;
      }
    }
  }
  if (supports.empty())
    return "";
  std::string names;
  for (std::size_t k = 0; k < std::min<std::size_t>(5, supports.size()); ++k)
    names += (k > 0 ? ", " : "") + model.scene.supports[supports[k]].name;
  if (supports.size() > 5)
    names += " and " + std::to_string(supports.size() - 5) + " more";
  return p.name.substr(0, p.name.find(':')) +
         " may not let stick where static friction holds: at " + names +
         ", whose friction elements are too stiff for the time step, so that what has stopped goes "
         "on to swing in them. Take moreau_jean, nonsmooth_alpha or event, a Shear rigidity that "
         "belongs to the support, or a shorter Time/Step.";
}

void AlphaScheme::start(LineState &state, const LoadCourse &loads) {
  if (!p.impulses)
    settle(state, loads.imposed(state.time));
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
