// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/body/continuum_newton.h"

#include "base/interruption.h"
#include "base/numbers.h"
#include <frictionbeam/contact/halving_search.h>
#include <frictionbeam/contact/tolerances.h>

#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace frictionbeam {

using namespace dealii;

namespace {

constexpr contact::AttemptLimits body_limits = {{1., 0.1, 10., 0.01}, 40, 15, 20, 6};
constexpr unsigned int most_stalls_of_body = 6, most_proximal_of_body = 15,
                       most_restarts_of_body = 2, most_iterations_of_increment = 500;
constexpr double stiffness_of_step = 1e6; ///< of rho, where Newton's step wants none
constexpr double epsilon_of_rounding = 64. * std::numeric_limits<double>::epsilon();
/// Of the diagonal, so that what moves freely has a direction in which it does: of a motion, and of
/// Newton's steps; there below the proximal stiffness as well.
constexpr double shift_of_motion = 1e-9, shift_of_step = 1e-6, shift_below_rho = 1e-3;

double largest_of(const ContinuumVector &vector) { return vector.linfty_norm(); }

} // namespace

template <int dim>
ContinuumNewton<dim>::ContinuumNewton(const ContinuumBody<dim> &body, ContinuumSystem &system,
                                      FoundationContacts &contacts)
    : body(body), system(system), contacts(contacts), settings(body.scene.solver),
      free_body(body, system), attempts(*this, contacts, body_limits) {
  body.reinit(diagonal);
  body.reinit(elastic);
  for (const auto dof : body.owned)
    diagonal(dof) = system.diagonal(dof);
}

template <int dim>
std::vector<LocalVector> ContinuumNewton<dim>::local(const ContinuumVector &u) const {
  std::vector<LocalVector> result(body.nodes.size(), LocalVector::Zero());
  for (unsigned int i = 0; i < body.nodes.size(); ++i)
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        result[i][a] += body.nodes[i].frame[a][d] * u(body.nodes[i].dofs[d]);
  return result;
}

template <int dim>
void ContinuumNewton<dim>::add_forces(const std::vector<LocalVector> &stress,
                                      ContinuumVector &forces) const {
  for (unsigned int i = 0; i < body.nodes.size(); ++i) {
    const auto &node = body.nodes[i];
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        if (!body.constraints.is_constrained(node.dofs[d]))
          forces(node.dofs[d]) += node.weight * node.frame[a][d] * stress[i][a];
  }
}

template <int dim>
void ContinuumNewton<dim>::residual(const std::vector<LocalVector> &stress,
                                    ContinuumVector &left) const {
  left = *loads;
  left -= elastic;
  add_forces(stress, left);
  body.constraints.set_zero(left);
}

template <int dim>
double ContinuumNewton<dim>::energy(const ContinuumVector &forces) const {
  double sum = 0.;
  for (const auto dof : body.owned)
    sum += forces(dof) * forces(dof) / diagonal(dof);
  return Utilities::MPI::sum(sum, body.communicator);
}

template <int dim>
std::pair<double, double>
ContinuumNewton<dim>::largest(const std::vector<LocalVector> &stress) const {
  double force = 0., traction = 0.;
  for (unsigned int i = 0; i < stress.size(); ++i) {
    traction = std::max(traction, stress[i].norm());
    force = std::max(force, body.nodes[i].weight * stress[i].norm());
  }
  return {Utilities::MPI::max(force, body.communicator),
          Utilities::MPI::max(traction, body.communicator)};
}

template <int dim>
double ContinuumNewton<dim>::or_least(const double largest, const double so_far) {
  return std::max(largest, contact::least_force * so_far);
}

template <int dim>
bool ContinuumNewton<dim>::all(const bool here) const {
  return Utilities::MPI::min(static_cast<unsigned int>(here), body.communicator) > 0;
}

template <int dim>
double ContinuumNewton<dim>::agreed(const double number) const {
  return Utilities::MPI::max(number, body.communicator);
}

template <int dim>
bool ContinuumNewton<dim>::gives_up(const ContinuumNewtonResult &result) const {
  return result.iterations >= most_iterations_of_increment;
}

template <int dim>
ContinuumNewtonResult ContinuumNewton<dim>::solve(const ContinuumVector &forces,
                                                  const FoundationState &state,
                                                  const LawIncrement &of_time, ContinuumVector &u,
                                                  FoundationResponse &response) {
  ContinuumNewtonResult result;
  loads = &forces;
  committed = &state;
  increment = of_time;
  largest_load = largest_of(forces);
  is_proof_sought = false;
  contacts.begin(state);
  contact::Outcome outcome = solve_contacts(u, response, result);
  while (outcome == contact::Outcome::solved && !all(!contacts.let_slipping_go(response.state)))
    outcome = solve_contacts(u, response, result);
  result.converged = outcome == contact::Outcome::solved;
  result.no_equilibrium = outcome == contact::Outcome::slides_away;
  if (result.converged) {
    const auto [force, traction] = largest(response.state.stress);
    force_so_far = std::max({force_so_far, largest_load, force});
    traction_so_far = std::max(traction_so_far, traction);
  }
  if (result.no_equilibrium)
    result.remark =
        "there is no equilibrium: the loads exceed what friction can hold, and the body "
        "slides away";
  else if (!result.converged)
    result.remark = "Newton's method on the contacts does not converge";
  return result;
}

template <int dim>
contact::Outcome ContinuumNewton<dim>::solve_contacts(ContinuumVector &u,
                                                      FoundationResponse &response,
                                                      ContinuumNewtonResult &result) {
  if (!contacts.are_exact()) // no centre, no rho: nothing else to try
    return solve_together(body_limits.most_together, u, response, result);
  const ContinuumVector start = u;
  const auto centre = contacts.centre;
  contact::Outcome outcome = attempts.solve(u, response, result);
  if (outcome == contact::Outcome::stalled && find_condensed_start(u))
    outcome = attempts.solve(u, response, result);
  if (outcome == contact::Outcome::stalled) {
    contacts.centre = centre;
    outcome = attempts.solve_from_elsewhere(most_restarts_of_body, start, u, response, result);
  }
  return outcome;
}

template <int dim>
void ContinuumNewton<dim>::evaluate(const ContinuumVector &u, FoundationResponse &response) {
  displacement = local(u);
  contacts.evaluate(displacement, *committed, increment, response);
  response.failed = !all(!response.failed);
  system.multiply(u, elastic);
  largest_displacement = largest_of(u);
}

template <int dim>
double ContinuumNewton<dim>::energy_together(const FoundationResponse &response,
                                             ContinuumVector &left) const {
  double misfit = 0.;
  std::vector<LocalVector> used = response.state.stress;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    if (!contacts.is_exact(i))
      continue;
    used[i] = contacts.centre[i];
    if (contacts.has_pressure(i))
      used[i][0] = response.state.stress[i][0];
    misfit += body.nodes[i].weight * response.misfit[i].cwiseAbs2().dot(contacts.by_centre(i));
  }
  residual(used, left);
  return energy(left) + Utilities::MPI::sum(misfit, body.communicator);
}

template <int dim>
contact::Check ContinuumNewton<dim>::check(const FoundationResponse &response) const {
  contact::Check check =
      contacts.check(displacement, response.state, *committed,
                     or_least(largest(response.state.stress).second, traction_so_far),
                     epsilon_of_rounding * largest_displacement);
  check.natural_map = Utilities::MPI::max(check.natural_map, body.communicator);
  check.penetration = Utilities::MPI::max(check.penetration, body.communicator);
  check.cone_violation = Utilities::MPI::max(check.cone_violation, body.communicator);
  check.slip_angle = Utilities::MPI::max(check.slip_angle, body.communicator);
  check.least_dissipation = Utilities::MPI::min(check.least_dissipation, body.communicator);
  return check;
}

template <int dim>
bool ContinuumNewton<dim>::balanced(const ContinuumVector &u, const ContinuumVector &left,
                                    const FoundationResponse &response,
                                    ContinuumNewtonResult &result) const {
  const double largest_force = or_least(
                   std::max(largest_load, largest(response.state.stress).first), force_so_far),
               size = largest_of(left);
  result.residual = largest_force > 0. ? size / largest_force : size;
  // What loads add up to, which does not depend on the mesh, excuses rounding: forces at single
  // nodes are the smaller the finer it is, those within a long wall that bends are not.
  const double all_loads = std::max(largest_force, loads->l1_norm());
  ContinuumVector stiff(u);
  stiff.scale(diagonal);
  return size <= std::max(settings.tolerance * largest_force,
                          std::min(epsilon_of_rounding * largest_of(stiff),
                                   contact::most_excused * all_loads));
}

template <int dim>
void ContinuumNewton<dim>::eliminate_centre(FoundationResponse &response,
                                            std::vector<LocalVector> &step) const {
  const double epsilon = contacts.stiffness_factor / stiffness_of_step;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    step[i].setZero();
    if (!contacts.is_exact(i))
      continue;
    LocalMatrix &D = response.tangent[i];
    LocalVector &stress = response.state.stress[i], centre = contacts.centre[i];
    if (contacts.has_pressure(i))
      centre[0] = stress[0];
    const LocalMatrix by_centre = -D * contacts.by_centre(i).asDiagonal();
    const Eigen::PartialPivLU<LocalMatrix> M(LocalMatrix::Identity() - (1. - epsilon) * by_centre);
    D = M.solve(LocalMatrix(D));
    step[i] = M.solve(response.misfit[i]);
    stress = centre + step[i];
  }
}

template <int dim>
bool ContinuumNewton<dim>::find_direction(const std::vector<LocalMatrix> &tangent,
                                          const double shift, const ContinuumVector &left,
                                          ContinuumVector &direction) {
  std::vector<ContinuumSystem::Block> blocks(contacts.size());
  bool symmetric = true;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const LocalMatrix &D = tangent[i];
    symmetric &= (D - D.transpose()).norm() <= no_component * D.norm();
    const auto &node = body.nodes[i];
    blocks[i].dofs.assign(node.dofs.begin(), node.dofs.end());
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b) {
        double value = a == b ? shift * contacts[i].normal_diagonal : 0.;
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int l = 0; l < dim; ++l)
            value -= node.frame[k][a] * D(k, l) * node.frame[l][b];
        blocks[i].values.push_back(node.weight * value);
      }
  }
  body.reinit(direction);
  return system.solve(blocks, all(symmetric), left, direction);
}

template <int dim>
bool ContinuumNewton<dim>::slides_away(const ContinuumVector &u, FoundationResponse &response) {
  evaluate(u, response);
  if (!is_proof_sought) {
    pushed_away = free_body.is_pushed_away(*loads, contacts.most_friction());
    is_proof_sought = true;
  }
  if (pushed_away)
    return *pushed_away;
  // Where a body tips over, what sticks is where it turns about.
  return moves_away(response, false) || moves_away(response, true);
}

template <int dim>
bool ContinuumNewton<dim>::moves_away(const FoundationResponse &response, const bool holds_stuck) {
  ContinuumVector left, motion, stiff;
  body.reinit(left);
  body.reinit(stiff);
  residual(response.state.stress, left);
  const double hold = largest_of(diagonal);
  std::vector<LocalMatrix> tangent(contacts.size(), LocalMatrix::Zero());
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const ContactStatus status = response.state.status[i];
    if (status != ContactStatus::open && !contacts.has_pressure(i)) // holds along its normal
      tangent[i](0, 0) = -hold / body.nodes[i].weight;
    if (status == ContactStatus::stick && holds_stuck)
      tangent[i](1, 1) = tangent[i](2, 2) = -hold / body.nodes[i].weight;
  }
  if (!find_direction(tangent, shift_of_motion, left, motion))
    return false;
  system.multiply(motion, stiff);
  body.constraints.set_zero(stiff);
  const double work = left * motion, stored = motion * stiff;
  if (!(work > 0.) || stored > 1e-3 * work)
    return false;
  const std::vector<LocalVector> rate = local(motion);
  const double fastest = largest_of(motion);
  bool utmost = true;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    utmost = utmost && contacts.gives_utmost(i, response.state, rate[i], fastest);
  return all(utmost);
}

template <int dim>
contact::Outcome ContinuumNewton<dim>::solve_proximal(ContinuumVector &u,
                                                      FoundationResponse &response,
                                                      ContinuumNewtonResult &result) {
  const double shift = std::min(shift_of_step, shift_below_rho * contacts.stiffness_factor);
  ContinuumVector left, direction;
  body.reinit(left);
  const auto go_on = [&]() {
    evaluate(u, response);
    residual(response.state.stress, left);
    return energy(left);
  };
  double before = go_on();
  for (unsigned int iteration = 0;; ++iteration) {
    interruption::end_if_overdue();
    if (response.failed)
      return contact::Outcome::stalled;
    if (balanced(u, left, response, result))
      return contact::Outcome::solved;
    ++result.iterations;
    if (iteration == most_proximal_of_body ||
        !find_direction(response.tangent, shift, left, direction))
      return slides_away(u, response) ? contact::Outcome::slides_away : contact::Outcome::stalled;
    const ContinuumVector start = u;
    const auto go = [&](const double length) {
      u = start;
      u.add(length, direction);
      return go_on();
    };
    before = contact::search_by_halving(go, before, 0.0625).merit;
  }
}

template <int dim>
contact::Outcome
ContinuumNewton<dim>::solve_together(const unsigned int most_iterations, ContinuumVector &u,
                                     FoundationResponse &response, ContinuumNewtonResult &result) {
  const unsigned int n = contacts.size();
  std::vector<LocalVector> step(n);
  ContinuumVector left, direction;
  body.reinit(left);
  evaluate(u, response);
  double before = energy_together(response, left);
  unsigned int stalls = 0;
  for (unsigned int iteration = 0;; ++iteration) {
    interruption::end_if_overdue();
    if (response.failed)
      return contact::Outcome::stalled;
    residual(response.state.stress, left);
    result.check = check(response);
    const bool last = iteration == most_iterations || stalls == most_stalls_of_body;
    if (balanced(u, left, response, result) && result.check.holds(settings.contact_tolerance) &&
        (last || result.check.natural_map <= 0.1 * settings.contact_tolerance))
      return contact::Outcome::solved;
    if (last)
      return slides_away(u, response) ? contact::Outcome::slides_away : contact::Outcome::stalled;

    eliminate_centre(response, step);
    residual(response.state.stress, left);
    ++result.iterations;
    if (!find_direction(response.tangent, 0., left, direction))
      return slides_away(u, response) ? contact::Outcome::slides_away : contact::Outcome::stalled;
    const auto motion = local(direction);
    for (unsigned int i = 0; i < n; ++i)
      if (contacts.is_exact(i))
        step[i] += response.tangent[i] * motion[i];

    const ContinuumVector start = u;
    const auto centre = contacts.centre;
    const auto go = [&](const double length) {
      u = start;
      u.add(length, direction);
      for (unsigned int i = 0; i < n; ++i)
        contacts.centre[i] = centre[i] + length * step[i];
      evaluate(u, response);
      return energy_together(response, left);
    };
    before = contact::take_step_of_both(go, before, stalls);
  }
}

template class ContinuumNewton<2>;
template class ContinuumNewton<3>;

} // namespace frictionbeam
