// SPDX-License-Identifier: LGPL-2.1-or-later
#include "active_set.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::contact {

namespace {

/// Of what a branch holds, beside the body's stiffness: c of the proximal law.
constexpr double stiffness_of_branch = 1e6;
/// Steps in all, and in a row without half as many changes as ever before.
constexpr unsigned int most_predictions = 20, most_steps_in_vain = 2;
constexpr unsigned int fewest_contacts = 100; ///< that a front is worth being sought among
constexpr unsigned int most_to_finish = 15, most_doublings_of_pause = 6;

/// Where forces alone tell it.
ContactStatus branch_by_forces(const Check::Point &point) {
  constexpr double near_the_limit = 1. - 1e-6;
  if (!(point.P > 0.))
    return point.gap <= 0. ? ContactStatus::stick : ContactStatus::open;
  const double limit = near_the_limit * point.friction * point.P;
  return std::hypot(point.T[0], point.T[1]) < limit ? ContactStatus::stick : ContactStatus::slip;
}

/// Branches of the proximal law that are chosen as long as this lives.
struct ChosenBranches {
  ChosenBranches(ProximalSites &proximal, std::vector<ContactStatus> branch) : proximal(proximal) {
    proximal.branch = std::move(branch);
  }
  ~ChosenBranches() { proximal.branch.clear(); }
  ProximalSites &proximal;
};

} // namespace

ActiveSet::ActiveSet(IncrementEquations &equations, Newton &newton)
    : equations(equations), newton(newton), proximal(equations.proximal),
      front(equations.S, equations.contacts, equations.unknowns_of_contacts()),
      points(equations.contacts.size()) {}

void ActiveSet::learn(const bool has_led_to_solution) {
  kept.failures = has_led_to_solution ? 0 : std::min(kept.failures + 1, most_doublings_of_pause);
  kept.pause = (1u << kept.failures) / 2 - (kept.failures > 0 ? 1 : 0);
}

void ActiveSet::remember(const std::vector<ContactStatus> &status, const Vector &motion) {
  kept.status = status;
  if (motion.size() > 0)
    kept.motion = motion;
}

std::vector<ContactStatus> ActiveSet::first_branches(const Response &response) const {
  std::vector<ContactStatus> branch(points.size(), ContactStatus::none);
  for (unsigned int i = 0; i < branch.size(); ++i) {
    if (!proximal.is_exact(i))
      continue;
    if (kept.status.size() == branch.size()) {
      branch[i] = kept.status[i] == ContactStatus::closed ? ContactStatus::stick : kept.status[i];
      continue;
    }
    branch[i] = branch_by_forces(equations.point_of(i, proximal.centre[i], 0., response));
  }
  return branch;
}

bool ActiveSet::step(Vector &x, Response &response, Result &result) {
  equations.evaluate(x, response);
  if (response.failed)
    return false;
  ++result.iterations;
  Vector motion;
  if (!equations.factor(response, result) ||
      !equations.solve(equations.forces_left(response), response, result, motion))
    return false;
  x += motion;
  const double rounding = equations.rounding_of_motion(x);
  for (unsigned int i = 0; i < points.size(); ++i) {
    if (!proximal.is_exact(i))
      continue;
    const Strains moved = equations.strain_of(i, motion);
    response.state.strain[i] += moved;
    proximal.centre[i] = response.stress[i] + response.tangent[i] * moved;
    points[i] = equations.point_of(i, proximal.centre[i], rounding, response);
  }
  return x.allFinite();
}

bool ActiveSet::is_nearer(const Vector &x, const std::vector<Strains> &centre, Response &response) {
  equations.evaluate(x, response);
  const double merit = equations.energy_together(response);
  const std::vector<Strains> predicted = proximal.centre;
  proximal.centre = centre;
  equations.evaluate(Vector::Zero(x.size()), response);
  const double at_start = equations.energy_together(response);
  proximal.centre = predicted;
  return merit < at_start / 2.;
}

bool ActiveSet::may_jam() const {
  for (unsigned int i = 0; i < points.size(); ++i)
    if (proximal.is_exact(i) && proximal.friction_coefficient(i) >= front.limit_of_uniqueness(i))
      return true;
  return false;
}

Outcome ActiveSet::solve(const bool is_first, const double factor, Vector &x, Response &response,
                         Result &result) {
  if (points.size() < fewest_contacts || may_jam())
    return Outcome::stalled;
  if (kept.pause > 0) {
    --kept.pause;
    return Outcome::stalled;
  }
  const std::vector<Strains> centre = proximal.centre;
  if (is_first && kept.motion.size() == x.size())
    x = kept.motion; // slip turns friction about as it did
  const bool is_settled = predict(x, response, result);
  proximal.stiffness_factor = factor;
  Outcome outcome = Outcome::stalled;
  if (is_settled || is_nearer(x, centre, response))
    outcome = newton.solve_together(most_to_finish, x, response, result);
  learn(outcome != Outcome::stalled);
  if (outcome == Outcome::stalled) { // as if it had not been tried
    proximal.centre = centre;
    x.setZero();
    newton.bar(false);
  }
  return outcome;
}

bool ActiveSet::predict(Vector &x, Response &response, Result &result) {
  proximal.stiffness_factor = stiffness_of_branch;
  equations.place(x, response);
  const ChosenBranches chosen(proximal, first_branches(response));
  unsigned int least_changes = points.size() + 1, n_in_vain = 0;
  for (unsigned int k = 0; k < most_predictions && n_in_vain < most_steps_in_vain; ++k) {
    if (equations.settings.in_each_iteration)
      equations.settings.in_each_iteration();
    if (!step(x, response, result))
      return false;
    const unsigned int n_changes = front.advance(points, proximal.branch);
    if (n_changes == 0)
      return true;
    for (unsigned int i = 0; i < points.size(); ++i)
      if (proximal.is_exact(i))
        proximal.centre[i].segment<2>(1) << points[i].T[0], points[i].T[1];
    n_in_vain = 2 * n_changes <= least_changes ? 0 : n_in_vain + 1;
    least_changes = std::min(least_changes, n_changes);
  }
  return false;
}

} // namespace frictionbeam::contact
