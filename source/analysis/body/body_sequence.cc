// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/body/body_sequence.h"

#include "analysis/contact/free_body.h"
#include "base/numbers.h"
#include "base/user_error.h"

#include <algorithm>
#include <map>

namespace frictionbeam {

using namespace dealii;

namespace {

std::vector<double> between(const std::vector<double> &a, const std::vector<double> &b,
                            const double part) {
  std::vector<double> result = a;
  for (std::size_t i = 0; i < a.size(); ++i)
    result[i] += part * (b[i] - a[i]);
  return result;
}

template <int dim>
std::unique_ptr<ContinuumSystem> make_system(const ContinuumBody<dim> &body,
                                             const Stiffening &stiffening) {
  if constexpr (dim == 3)
    if (stiffening.assemble)
      return make_stiffened_system(body, stiffening.assemble);
  return make_continuum_system(body);
}

/// @throws UserError if a pressure alone keeps a body on its frictional surface
template <int dim>
void check_that_body_is_held(const ContinuumBody<dim> &body, const ContinuumSystem &system) {
  const std::vector<ContinuumContact> &surfaces = body.continuum.contacts;
  if (std::none_of(surfaces.begin(), surfaces.end(),
                   [](const ContinuumContact &surface) { return surface.pressure.has_value(); }))
    return;
  std::vector<bool> is_pressed;
  for (const ContinuumContactNode<dim> &node : body.nodes)
    is_pressed.push_back(surfaces[node.surface].pressure.has_value());
  if (FreeBody<dim>(body, system).rises_freely(is_pressed))
    throw UserError(
        "Nothing holds the body along the normal of its frictional surface.\n"
        "  read:    a Pressure on it, which is a load and holds nothing, and no other hold\n"
        "  allowed: a body that cannot move as a whole but along what friction holds\n"
        "  try:     in Held, a part that faces the surface, with the direction of the normal; or "
        "no Pressure, so that the surface holds by contact, and what presses on it in Loaded");
}

} // namespace

template <int dim>
std::vector<FoundationPoint> foundation_points(const ContinuumBody<dim> &body,
                                               const ContinuumSystem &system) {
  // Surfaces that meet at a node share it by their areas: the pressure is the same on both.
  std::map<types::global_dof_index, double> area;
  for (const auto &node : body.nodes)
    area[node.dofs[0]] += node.weight;
  std::vector<FoundationPoint> points;
  for (const auto &node : body.nodes) {
    FoundationPoint point;
    point.surface = node.surface;
    point.weight = node.weight;
    for (unsigned int a = 0; a < dim; ++a) {
      double k = 0.;
      bool is_held = false;
      for (unsigned int d = 0; d < dim; ++d) {
        k += node.frame[a][d] * node.frame[a][d] * system.diagonal(node.dofs[d]) /
             area[node.dofs[0]];
        is_held = is_held || (std::abs(node.frame[a][d]) > no_direction &&
                              body.constraints.is_constrained(node.dofs[d]));
      }
      if (a == 0)
        point.normal_diagonal = k;
      else if (!is_held) // the stiffer of the two tangents
        point.shear_diagonal = std::max(point.shear_diagonal, k);
    }
    if (point.shear_diagonal == 0.) // which slides nowhere
      point.shear_diagonal = point.normal_diagonal;
    points.push_back(point);
  }
  return points;
}

template <int dim>
ContinuumVector nodal_tractions(const ContinuumBody<dim> &body, const ContinuumState &state) {
  ContinuumVector traction;
  body.reinit(traction);
  for (unsigned int i = 0; i < body.nodes.size(); ++i)
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        traction(body.nodes[i].dofs[d]) += body.nodes[i].frame[a][d] * state.contacts.stress[i][a];
  return traction;
}

template <int dim>
ContinuumSequence<dim>::ContinuumSequence(const ContinuumBody<dim> &body, const LawLibrary &laws)
    : ContinuumSequence(body, laws, {body.traction_forces()}) {}

template <int dim>
ContinuumSequence<dim>::ContinuumSequence(const ContinuumBody<dim> &body, const LawLibrary &laws,
                                          std::vector<ContinuumVector> loads,
                                          Stiffening of_pressure)
    : body(body), stiffening(std::move(of_pressure)), system(make_system(body, stiffening)),
      foundation(body.continuum, laws, body.scene.solver.is_exact(),
                 foundation_points(body, *system)),
      newton(body, *system, foundation), unit_forces(std::move(loads)),
      load_factors(unit_forces.size(), 0.) {
  check_that_body_is_held(body, *system);
  body.reinit(unknowns);
}

template <int dim>
void ContinuumSequence<dim>::start(const ContinuumGuess *guess) {
  const auto &steps = body.continuum.steps;
  committed = foundation.initial_state();
  step_ends.reserve(steps.size());
  if (guess == nullptr || steps.size() > 1 || steps[0].n_increments > 1)
    return;
  unknowns = guess->displacement;
  body.constraints.set_zero(unknowns);
  for (unsigned int i = 0; i < body.nodes.size(); ++i)
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        foundation.centre[i][a] +=
            body.nodes[i].frame[a][d] * guess->traction(body.nodes[i].dofs[d]);
}

template <int dim>
void ContinuumSequence<dim>::start_step() {
  StepReport report;
  report.step = body.continuum.steps[position.step].name;
  step_reports.push_back(report);
  position.from = load_factors;
  position.next = 0;
}

template <int dim>
bool ContinuumSequence<dim>::run(const ContinuumGuess *guess, const Pause &pause) {
  const auto &steps = body.continuum.steps;
  if (!is_resumed)
    start(guess);
  for (unsigned int &s = position.step; s < steps.size(); ++s) {
    if (!is_resumed)
      start_step();
    is_resumed = false;
    const unsigned int n = steps[s].n_increments;
    const Factors begin = position.from, end = steps[s].load_factors();
    const double duration = 1. / n;
    const auto part = [&](const unsigned int i) {
      return i == n ? end : between(begin, end, i * duration);
    };
    for (unsigned int &i = position.next; i < n;) {
      if (!advance(part(i), part(i + 1), s + i * duration, duration,
                   body.scene.solver.max_halvings)) {
        keep(s, i, load_factors);
        return false;
      }
      ++i;
      ++step_reports.back().increments;
      if (pause)
        pause();
    }
    step_reports.back().converged = true;
    keep(s, n, end);
  }
  return true;
}

template <int dim>
void ContinuumSequence<dim>::transfer(Archive &archive) {
  const auto transfer_own = [&](ContinuumVector &vector) {
    if (archive.reads())
      body.reinit(vector);
    std::vector<double> values(vector.begin(), vector.end());
    archive(values);
    if (archive.reads())
      std::copy(values.begin(), values.end(), vector.begin());
  };
  std::size_t n_ends = step_ends.size();
  archive(position, load_factors, now, committed, foundation, newton, step_reports, n_reported,
          *system, n_ends);
  transfer_own(unknowns);
  if (archive.reads())
    step_ends.reserve(body.continuum.steps.size()); // which the states to come stay in
  step_ends.resize(n_ends);
  for (ContinuumState &state : step_ends) {
    archive(state.step, state.increment, state.time, state.factor, state.factors, state.contacts,
            state.contact_displacement);
    transfer_own(state.displacement);
    if (archive.reads())
      state.displacement.update_ghost_values();
  }
  is_resumed = archive.reads();
  if (is_resumed) { // the factors were counted when they were made
    const unsigned int counted = system->n_factorizations;
    AssertThrow(stiffen(load_factors), ExcInternalError());
    system->n_factorizations = counted;
  }
}

template <int dim>
bool ContinuumSequence<dim>::advance(const Factors &from, const Factors &to, const double start,
                                     const double duration, const unsigned int halvings) {
  if (increment(to, start + duration, duration))
    return true;
  if (halvings == 0 || step_reports.back().no_equilibrium)
    return false;
  ++step_reports.back().halvings;
  const Factors middle = between(from, to, 0.5);
  return advance(from, middle, start, duration / 2., halvings - 1) &&
         advance(middle, to, start + duration / 2., duration / 2., halvings - 1);
}

template <int dim>
bool ContinuumSequence<dim>::stiffen(const Factors &factors) {
  return system->stiffen(stiffening_at(factors));
}

template <int dim>
ContinuumVector ContinuumSequence<dim>::loads_at(const Factors &factors) const {
  ContinuumVector loads;
  body.reinit(loads);
  for (std::size_t l = 0; l < unit_forces.size(); ++l)
    loads.add(factors[l], unit_forces[l]);
  if (const double p = stiffening_at(factors); p != 0.)
    loads.add(p * p, stiffening.of_itself);
  return loads;
}

template <int dim>
bool ContinuumSequence<dim>::increment(const Factors &factors, const double time,
                                       const double time_increment) {
  StepReport &report = step_reports.back();
  if (!stiffen(factors)) {
    report.no_equilibrium = foundation.size() == 0; // else contacts may hold it
    report.remark = "the wall buckles under its pressure: with it the stiffness of the elastic "
                    "body is not positive definite any more";
    return false;
  }
  const ContinuumVector loads = loads_at(factors);
  ContinuumVector u = unknowns;
  FoundationResponse response;
  const auto centre = foundation.centre;
  const ContinuumNewtonResult result =
      newton.solve(loads, committed,
                   {time, time_increment, body.scene.installation_temperature}, // nothing heats it
                   u, response);
  report.iterations += result.iterations;
  report.factorizations += system->n_factorizations - n_reported;
  n_reported = system->n_factorizations;
  if (!result.converged) {
    foundation.centre = centre;
    report.remark = result.remark;
    report.no_equilibrium = result.no_equilibrium;
    return false;
  }
  report.remark.clear();
  report.residual = std::max(report.residual, result.residual);
  report.contact.include(result.check);
  account(u, loads, stiffening_at(factors) - stiffening_at(load_factors), response.state);
  unknowns = u;
  committed = response.state;
  foundation.centre = committed.stress;
  load_factors = factors;
  now = time;
  return true;
}

template <int dim>
void ContinuumSequence<dim>::account(const ContinuumVector &u, const ContinuumVector &loads,
                                     const double pressure_rise, const FoundationState &contacts) {
  EnergyAccount account;
  ContinuumVector stiff, motion = u, mean_load = loads, sum = u;
  body.reinit(stiff);
  const bool first = now == 0.; // a guess is no motion
  ContinuumVector start = unknowns;
  if (first)
    start = 0.;
  motion -= start;
  sum += start;
  mean_load += loads_at(load_factors);
  mean_load *= 0.5;
  account.external = mean_load * motion;
  system->multiply(sum, stiff);
  body.constraints.set_zero(motion);
  account.stored = 0.5 * (stiff * motion);
  if (pressure_rise != 0.) { // u K u / 2 grows with K as well, by work of the pressure
    system->multiply_stiffening(start, stiff);
    body.constraints.set_zero(stiff);
    account.stored += 0.5 * pressure_rise * (stiff * start);
    account.external += 0.5 * pressure_rise * (stiff * u);
  }
  const auto displacement = newton.local(motion);
  double pressure_work = 0., gaps = 0., slip_work = 0., missed = 0.;
  for (unsigned int i = 0; i < foundation.size(); ++i) {
    const double w = foundation[i].weight;
    // Everything grows from nothing in the first increment, a prescribed pressure as well.
    const LocalVector before = first ? LocalVector(LocalVector::Zero()) : committed.stress[i];
    const LocalVector mean = 0.5 * (before + contacts.stress[i]);
    (foundation.has_pressure(i) ? pressure_work : gaps) +=
        (foundation.has_pressure(i) ? w : -w) * mean[0] * displacement[i][0];
    slip_work -= w * mean.template tail<2>().dot(displacement[i].template tail<2>());
    missed += 0.5 * w *
              std::abs((contacts.stress[i] - before)
                           .template tail<2>()
                           .dot(displacement[i].template tail<2>()));
  }
  account.external += Utilities::MPI::sum(pressure_work, body.communicator);
  account.gaps = Utilities::MPI::sum(gaps, body.communicator);
  account.dissipated = Utilities::MPI::sum(slip_work, body.communicator);
  account.missed_friction = Utilities::MPI::sum(missed, body.communicator);
  account.turnover = std::abs(account.external) + std::abs(account.stored) +
                     std::abs(account.dissipated) + std::abs(account.gaps);
  step_reports.back().energy += account;
}

template <int dim>
void ContinuumSequence<dim>::keep(const unsigned int step, const unsigned int increment,
                                  const Factors &factors) {
  ContinuumState state;
  state.step = step;
  state.increment = increment;
  state.factor = factors[0];
  state.factors = factors;
  state.time = now;
  state.displacement = unknowns;
  body.constraints.distribute(state.displacement);
  state.contacts = committed;
  state.contact_displacement = newton.local(unknowns);
  step_ends.push_back(state);
  step_ends.back().displacement.update_ghost_values(); // which a copy does not take along
}

template <int dim>
ContinuumGuess ContinuumSequence<dim>::as_guess() const {
  ContinuumGuess guess;
  guess.displacement = step_ends.back().displacement;
  guess.displacement.update_ghost_values();
  guess.traction = nodal_tractions(body, step_ends.back());
  body.constraints.distribute(guess.traction); // conforming, so that it can be interpolated
  guess.traction.update_ghost_values();
  return guess;
}

template ContinuumVector nodal_tractions<2>(const ContinuumBody<2> &, const ContinuumState &);
template ContinuumVector nodal_tractions<3>(const ContinuumBody<3> &, const ContinuumState &);
template class ContinuumSequence<2>;
template class ContinuumSequence<3>;
template std::vector<FoundationPoint> foundation_points<2>(const ContinuumBody<2> &,
                                                           const ContinuumSystem &);
template std::vector<FoundationPoint> foundation_points<3>(const ContinuumBody<3> &,
                                                           const ContinuumSystem &);

} // namespace frictionbeam
