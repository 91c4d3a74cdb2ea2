// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/exact_solver.h"

#include "analysis/contact/opposed_contacts.h"

#include <algorithm>
#include <optional>

namespace frictionbeam {

namespace {

constexpr AttemptLimits limits = {{1e-4, 1e-3, 1e-5, 1e-2}, 30};
constexpr unsigned int most_refinements = 5, most_releases = 5;
constexpr double in_common_least = 1e-9; // of the larger force of a pair
constexpr double nothing_left = 1e-4; // part of the tolerance at which nothing is left to correct
/// In motion, a shorter step helps as well.
constexpr unsigned int most_restarts = 30, most_restarts_in_motion = 3;

} // namespace

ExactSolver::ExactSolver(const SolverSettings &settings, const Contacts &contacts,
                         const ReducedSpace &space, const SparseMatrix &stiffness)
    : settings(settings), contacts(contacts), space(space), line(stiffness, contacts),
      proximal(contacts, stiffness), newton(settings, contacts, line, proximal),
      attempts(newton, proximal, limits), diagonal(stiffness.diagonal()),
      pairs(rigid_pairs(contacts)) {}

ContactOutcome ExactSolver::solve_contacts(const unsigned int most_restarts, Vector &x,
                                           ContactResponse &response, EquilibriumResult &result) {
  const Outcome outcome = attempts.solve(x, response, result);
  if (outcome != Outcome::stalled || newton.gives_up(result))
    return outcome;
  const Vector start = Vector::Zero(line.n_kept());
  return attempts.solve_from_elsewhere(most_restarts, start, x, response, result);
}

void ExactSolver::explain(const Outcome outcome, EquilibriumResult &result) const {
  result.no_equilibrium = outcome == Outcome::slides_away;
  if (result.no_equilibrium)
    result.remark = "there is no equilibrium: the loads exceed what friction can hold, and the "
                    "line slides away";
  else if (newton.rounding_bars()) {
    result.rounding_bars = true;
    result.remark = newton.rounding_remark();
  }
}

/// An increment on its way to its solution, pass by pass.
struct ExactSolver::Increment {
  /// A solution within the tolerance, kept while something is tried that may fail.
  struct Accepted {
    Vector unknowns;
    ContactResponse response;
    std::vector<Contact::Strains> centre;
    double residual;
  };

  const EquilibriumProblem &problem;
  const ContactState &committed;
  Vector &unknowns;
  ContactResponse &response;
  EquilibriumResult result = {};
  /// A line may deflect so far that its stiffness times a rounding error of the unknowns is a
  /// force: what rounding takes from them is kept until the increment is judged.
  Vector low = Vector::Zero(unknowns.size());
  double size = 0., largest = 0.; ///< what is left, and the largest force [N]
  std::optional<Accepted> accepted = {};
  unsigned int n_releases = 0;
  bool is_corrected = false;

  bool is_static() const { return problem.increment.length == 0.; }
  void accept(const std::vector<Contact::Strains> &centre) {
    accepted = {unknowns, response, centre, result.residual};
  }
};

bool ExactSolver::move(Increment &now) {
  const EquilibriumProblem &problem = now.problem;
  now.result.rounding_bars = false;
  Vector dofs;
  space.expand(now.unknowns, dofs);
  dofs += problem.imposed;
  const Vector forces = unbalanced_forces(problem, now.unknowns, now.low);
  newton.begin(forces,
               std::max(problem.largest_force, problem.right_hand_side.lpNorm<Eigen::Infinity>()),
               problem.force_so_far, dofs, now.committed, problem.increment);
  Vector x = Vector::Zero(line.n_kept());
  const Outcome outcome =
      now.accepted ? newton.solve_together(limits.most_to_finish, x, now.response, now.result)
                   : solve_contacts(now.is_static() ? most_restarts : most_restarts_in_motion, x,
                                    now.response, now.result);
  if (outcome != Outcome::solved) {
    if (!now.accepted)
      explain(outcome, now.result);
    return false;
  }
  const Vector before = now.unknowns, change = now.low + line.expand(x, forces);
  now.result.back_substitutions += 2; // one to condense the loads, one to expand
  now.unknowns += change;
  now.low = change - (now.unknowns - before);
  return true;
}

bool ExactSolver::is_balanced(Increment &now) const {
  const Residual residual(now.problem, contacts, space, {});
  const Vector left = residual.with_stress(now.unknowns, now.low, now.response);
  now.size = left.lpNorm<Eigen::Infinity>();
  now.largest = residual.largest_force(now.response);
  now.result.residual = now.largest > 0. ? now.size / now.largest : now.size;
  return now.size <= residual.tolerance(settings.tolerance, diagonal, now.unknowns, now.response);
}

bool ExactSolver::goes_on(Increment &now) {
  if (proximal.let_slipping_go(now.response)) {
    now.accepted.reset();
    proximal.take_all();
    return true;
  }
  if (now.n_releases < most_releases && presses_pairs(now.response)) {
    ++now.n_releases;
    now.accept(proximal.centre);
    release_pairs(now.response);
    return true;
  }
  // One more correction costs no more than a back substitution where the contacts' states stay,
  // and takes what rounding of a soft line's stiffness has left.
  if (!now.is_corrected && now.is_static() &&
      now.size > nothing_left * settings.tolerance * now.largest) {
    now.is_corrected = true;
    now.accept(proximal.centre);
    return true;
  }
  return false;
}

EquilibriumResult ExactSolver::solve(const EquilibriumProblem &problem,
                                     const ContactState &committed, Vector &unknowns,
                                     ContactResponse &response) {
  proximal.begin(committed, problem.overrides);
  newton.most_iterations = problem.most_iterations;
  for (unsigned int i = 0; i < contacts.size() && problem.forces_before != nullptr; ++i)
    if (proximal.is_exact(i))
      proximal.centre[i] = (*problem.forces_before)[i];
  const auto centre_before = proximal.centre;
  const Vector unknowns_before = unknowns;
  Increment now{problem, committed, unknowns, response};
  EquilibriumResult &result = now.result;
  for (unsigned int pass = 0; pass <= most_refinements + now.n_releases && move(now); ++pass) {
    if (!is_balanced(now)) {
      result.rounding_bars = true;
      result.remark = too_much_rounding(now.size, now.largest);
      continue;
    }
    if (goes_on(now))
      continue;
    if (judge(response, result))
      return result;
    break;
  }
  if (now.accepted) { // the correction has not helped
    result.rounding_bars = false;
    unknowns = now.accepted->unknowns;
    response = now.accepted->response;
    proximal.centre = now.accepted->centre;
    result.residual = now.accepted->residual;
    if (judge(response, result))
      return result;
  }
  if (result.iterations >= problem.most_iterations && !result.no_equilibrium)
    result.remark = "no convergence in " + std::to_string(result.iterations) + " iterations";
  proximal.centre = centre_before;
  unknowns = unknowns_before;
  return result;
}

bool ExactSolver::judge(const ContactResponse &response, EquilibriumResult &result) const {
  result.check = newton.check(response);
  result.converged = result.check->holds(settings.contact_tolerance);
  result.remark = result.converged ? "" : "the contact laws fail their check";
  return result.converged;
}

double ExactSolver::force_in_common(const Pair &pair, const ContactResponse &response) const {
  const auto force = [&](const unsigned int i) {
    return -contacts[i].share() * response.stress[i][0];
  };
  const auto [less, more] = std::minmax({force(pair[0]), force(pair[1])});
  return less > in_common_least * more ? less : 0.;
}

bool ExactSolver::presses_pairs(const ContactResponse &response) const {
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const Pair &pair) { return force_in_common(pair, response) > 0.; });
}

void ExactSolver::release_pairs(const ContactResponse &response) {
  for (const Pair &pair : pairs) {
    const double force = force_in_common(pair, response);
    if (!(force > 0.))
      continue;
    const auto pressure = [&](const unsigned int i) { return -response.stress[i][0]; };
    const bool first_is_less = contacts[pair[0]].share() * pressure(pair[0]) <
                               contacts[pair[1]].share() * pressure(pair[1]);
    const unsigned int less = pair[first_is_less ? 0 : 1], more = pair[first_is_less ? 1 : 0];
    proximal.centre[more][0] += force / contacts[more].share();
    proximal.centre[less].setZero();
    proximal.leave_out(less);
  }
}

} // namespace frictionbeam
