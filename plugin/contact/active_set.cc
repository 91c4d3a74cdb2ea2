// SPDX-License-Identifier: LGPL-2.1-or-later
#include "active_set.h"
#include <frictionbeam/disc_projection.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam::contact {

namespace {

/// Of what a branch holds, beside the body's stiffness: c of the proximal law.
constexpr double stiffness_of_branch = 1e6;
/// The same of the step that comes before all others where no front is sought, around forces or
/// none.
constexpr double stiffness_of_approach = 3e-2, stiffness_from_no_forces = 1e-2;
/// Steps in all, and in a row without half as many changes as ever before.
constexpr unsigned int most_predictions = 20, most_steps_in_vain = 2;
constexpr unsigned int fewest_contacts = 100; ///< that a front is worth being sought among
constexpr unsigned int most_to_finish = 15, most_of_few = 30, most_doublings_of_pause = 6;
/// Of the energy in a step from there. With 1, steps are cut short at kinks, and 4 cycles.
constexpr double most_rise_of_few = 2.;

/// Where forces alone tell it.
ContactStatus branch_by_forces(const Check::Point &point) {
  constexpr double near_the_limit = 1. - 1e-6;
  if (!(point.P > 0.))
    return point.gap <= 0. ? ContactStatus::stick : ContactStatus::open;
  const double limit = near_the_limit * point.friction * point.P;
  return length_of(point.T[0], point.T[1]) < limit ? ContactStatus::stick : ContactStatus::slip;
}

/// Its friction, or what it can hold of it: the force that a branch yields to is its guess.
Eigen::Vector2d within_limit(const Check::Point &point) {
  const double size = length_of(point.T[0], point.T[1]),
               limit = point.friction * std::max(0., point.P);
  return (size > limit ? limit / size : 1.) * Eigen::Vector2d(point.T[0], point.T[1]);
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
  kept.status = settled.empty() ? status : settled; // at its limit a contact may have either
  settled.clear();
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
  yielded = 0.;
  for (unsigned int i = 0; i < points.size(); ++i) {
    if (!proximal.is_exact(i))
      continue;
    const Strains moved = equations.strain_of(i, motion), before = proximal.centre[i];
    response.state.strain[i] += moved;
    proximal.centre[i] = response.stress[i] + response.tangent[i] * moved;
    yielded = std::max(yielded, equations.contacts[i].largest_force(proximal.centre[i] - before));
  }
  yielded /= stiffness_of_branch;
  look_at_points(equations.rounding_of_motion(x), response);
  return x.allFinite();
}

void ActiveSet::look_at_points(const double rounding, const Response &response) {
  constexpr double of_forces = 8. * std::numeric_limits<double>::epsilon();
  for (unsigned int i = 0; i < points.size(); ++i) {
    if (!proximal.is_exact(i))
      continue;
    Check::Point &point = points[i];
    point = equations.point_of(i, proximal.centre[i], rounding, response);
    // Where a contact was held off its branch, forces that bring it there cancel.
    const double cancelled = response.stress[i].head<3>().lpNorm<Eigen::Infinity>();
    point.rounding += of_forces * cancelled / point.shear_scale;
  }
}

double ActiveSet::excess() const {
  double largest = 0.;
  for (unsigned int i = 0; i < points.size(); ++i)
    if (proximal.is_exact(i))
      largest = std::max(largest, equations.contacts[i].share() *
                                      (length_of(points[i].T[0], points[i].T[1]) -
                                       points[i].friction * std::max(0., points[i].P)));
  return largest;
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

template <typename Friction>
bool ActiveSet::is_beyond_uniqueness(const Friction &friction) const {
  for (unsigned int i = 0; i < points.size(); ++i)
    if (proximal.is_exact(i) && friction(i) >= front.limit_of_uniqueness(i))
      return true;
  return false;
}

bool ActiveSet::may_jam() const {
  return is_beyond_uniqueness(
      [this](const unsigned int i) { return proximal.friction_coefficient(i); });
}

bool ActiveSet::may_ever_jam() const {
  return is_beyond_uniqueness([this](const unsigned int i) {
    return equations.contacts[i].law.closed_form().static_friction;
  });
}

Outcome ActiveSet::solve(const bool is_first, const double factor, Vector &x, Response &response,
                         Result &result) {
  begin();
  if (may_jam())
    return Outcome::stalled;
  if (kept.pause > 0) {
    --kept.pause;
    return Outcome::stalled;
  }
  if (points.size() < fewest_contacts)
    return solve_few(is_first, factor, x, response, result);
  const std::vector<Strains> centre = proximal.centre;
  if (is_first && kept.motion.size() == x.size())
    x = kept.motion; // slip turns friction about as it did
  const bool is_settled = predict(is_first, x, response, result);
  if (is_settled && is_first) { // what its branches have yielded, a correction takes
    has_solved = is_sketched = true;
    proximal.stiffness_factor = factor;
    return Outcome::solved;
  }
  const unsigned int n_iterations = result.iterations;
  proximal.stiffness_factor = factor;
  Outcome outcome = Outcome::stalled;
  if (is_settled || is_nearer(x, centre, response))
    outcome =
        newton.solve_together(most_to_finish, x, response, result, is_settled ? excess() : 0.);
  if (outcome != Outcome::solved || result.iterations > n_iterations)
    settled.clear();
  learn(outcome != Outcome::stalled);
  has_solved = outcome == Outcome::solved;
  if (outcome == Outcome::stalled) { // as if it had not been tried
    proximal.centre = centre;
    x.setZero();
    newton.bar(false);
  }
  return outcome;
}

Vector ActiveSet::like_before(Response &response) {
  equations.evaluate(Vector::Zero(kept.motion.size()), response);
  const double stored = kept.motion.dot(equations.S * kept.motion),
               done = equations.forces_left(response).dot(kept.motion);
  return stored > 0. ? std::clamp(std::round(done / stored), -1., 1.) * kept.motion : kept.motion;
}

Outcome ActiveSet::solve_few(const bool is_first, const double factor, Vector &x,
                             Response &response, Result &result) {
  // In motion states hardly change from step to step, and factors are kept.
  if (equations.is_in_motion())
    return Outcome::stalled;
  const bool has_forces = std::any_of(proximal.centre.begin(), proximal.centre.end(),
                                      [](const Strains &stress) { return stress[0] != 0.; });
  const std::vector<Strains> centre = proximal.centre;
  proximal.stiffness_factor = has_forces ? stiffness_of_approach : stiffness_from_no_forces;
  if (is_first && kept.motion.size() == x.size())
    x = like_before(response);
  Outcome outcome = Outcome::stalled;
  if (newton.approach(x, response, result)) {
    proximal.stiffness_factor = factor;
    outcome = newton.solve_together(most_of_few, x, response, result, 0., most_rise_of_few);
  }
  if (outcome == Outcome::solved && !equations.is_held(response, result))
    outcome = Outcome::stalled;
  learn(outcome != Outcome::stalled);
  if (outcome == Outcome::stalled) {
    proximal.centre = centre;
    x.setZero();
    newton.bar(false);
  }
  return outcome;
}

Outcome ActiveSet::correct(Vector &x, Response &response, Result &result) {
  if (!has_solved)
    return Outcome::stalled;
  has_solved = false;
  const std::vector<Strains> centre = proximal.centre;
  const double factor = proximal.stiffness_factor;
  proximal.stiffness_factor = stiffness_of_branch;
  bool is_near = false;
  {
    const ChosenBranches chosen(proximal, first_branches(response));
    is_near = step(x, response, result);
  }
  proximal.stiffness_factor = factor;
  const unsigned int n_iterations = result.iterations;
  Outcome outcome = Outcome::stalled;
  if (is_near)
    outcome = newton.solve_together(most_to_finish, x, response, result, excess());
  if (outcome == Outcome::solved && result.iterations == n_iterations)
    settled = kept.status;
  if (is_sketched) // a failure after others makes a longer pause
    learn(outcome != Outcome::stalled);
  is_sketched = false;
  if (outcome == Outcome::stalled) {
    proximal.centre = centre;
    x.setZero();
    newton.bar(false);
  }
  return outcome;
}

void ActiveSet::learn_how_far(const std::vector<ContactStatus> &sketch,
                              const unsigned int n_fronts) {
  double missing = 0.;
  for (unsigned int i = 0; i < sketch.size(); ++i)
    if (sketch[i] != settled[i])
      missing += settled[i] == ContactStatus::slip ? 1. : -1.;
  kept.further += std::lround(missing / n_fronts);
}

bool ActiveSet::predict(const bool is_first, Vector &x, Response &response, Result &result) {
  proximal.stiffness_factor = stiffness_of_branch;
  if (kept.status.size() != points.size()) // the first ones are told by forces and gaps
    equations.place(x, response);
  const ChosenBranches chosen(proximal, first_branches(response));
  unsigned int least_changes = points.size() + 1, n_in_vain = 0, n_fronts = 0;
  std::vector<ContactStatus> sketch;
  for (unsigned int k = 0; k < most_predictions && n_in_vain < most_steps_in_vain; ++k) {
    if (equations.settings.in_each_iteration)
      equations.settings.in_each_iteration();
    if (!step(x, response, result))
      return false;
    const unsigned int n_changes = front.advance(points, proximal.branch, yielded);
    if (n_changes == 0) {
      settled = proximal.branch;
      if (n_fronts > 0)
        learn_how_far(sketch, n_fronts);
      return is_first || step(x, response, result); // what a branch has yielded, it holds now
    }
    for (unsigned int i = 0; i < points.size(); ++i)
      if (proximal.is_exact(i))
        proximal.centre[i].segment<2>(1) = within_limit(points[i]);
    if (k == 0 && is_first) {
      n_fronts = front.move(proximal.branch, kept.further);
      sketch = proximal.branch;
    }
    n_in_vain = 2 * n_changes <= least_changes ? 0 : n_in_vain + 1;
    least_changes = std::min(least_changes, n_changes);
  }
  return false;
}

} // namespace frictionbeam::contact
