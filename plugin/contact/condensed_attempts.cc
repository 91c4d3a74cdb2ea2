// SPDX-License-Identifier: LGPL-2.1-or-later
#include "condensed_attempts.h"

namespace frictionbeam::contact {

namespace {

constexpr AttemptLimits limits_of_line = {{1e-4, 1e-3, 1e-5, 1e-2}, 30};
/// The stiffness of a body at a contact is nearly the diagonal's: with a small c few contacts
/// change their state in an iteration. That of a line, bent between supports, is far below it.
constexpr AttemptLimits limits_of_body = {{1e-1, 1e-2, 1e-3, 1e-4}, 30};
/// In motion, a shorter step helps as well.
constexpr unsigned int most_restarts_at_rest = 30, most_restarts_in_motion = 3;
constexpr double drag_of_proof = 1e-9; // of the stiffness's diagonal

} // namespace

CondensedAttempts::CondensedAttempts(IncrementEquations &equations, Newton &newton)
    : limits(equations.is_of_body() ? limits_of_body : limits_of_line), equations(equations),
      newton(newton), proximal(equations.proximal), attempts(newton, proximal, limits) {}

Outcome CondensedAttempts::solve_with_drag(Vector &x, Response &response, Result &result) {
  newton.set_drag(drag_of_proof);
  x = Vector::Zero(equations.S.rows());
  Outcome outcome = attempts.solve(x, response, result);
  if (outcome == Outcome::solved)
    outcome = newton.drag_alone_holds(x, response) ? Outcome::slides_away : Outcome::stalled;
  newton.set_drag(0.);
  return outcome;
}

Outcome CondensedAttempts::solve_from_balanced_forces(Vector &x, Response &response,
                                                      Result &result) {
  const auto forces = newton.balanced_forces();
  if (!forces)
    return Outcome::stalled;
  proximal.centre = *forces;
  x = Vector::Zero(equations.S.rows());
  return attempts.solve(x, response, result);
}

Outcome CondensedAttempts::solve(const bool is_static, Vector &x, Response &response,
                                 Result &result) {
  const std::vector<Strains> centre = proximal.centre;
  Outcome outcome = attempts.solve(x, response, result);
  const bool is_guess = outcome == Outcome::slides_away && newton.is_guess();
  if (is_guess) {
    proximal.centre = centre;
    if (solve_with_drag(x, response, result) == Outcome::slides_away)
      return Outcome::slides_away;
    newton.refute();
    proximal.centre = centre;
    x = Vector::Zero(equations.S.rows());
    outcome = attempts.solve(x, response, result);
  }
  if (outcome != Outcome::stalled || result.iterations >= newton.most_iterations)
    return outcome;
  const bool is_barred = newton.rounding_bars();
  if (is_static) {
    const std::vector<Strains> found = proximal.centre;
    proximal.centre = centre;
    if (!is_guess && solve_with_drag(x, response, result) == Outcome::slides_away)
      return Outcome::slides_away;
    const Outcome from_forces = solve_from_balanced_forces(x, response, result);
    if (from_forces != Outcome::stalled)
      return from_forces;
    proximal.centre = found;
    newton.bar(is_barred);
  }
  if (newton.gives_up(result))
    return outcome;
  const unsigned int most_restarts = is_static ? most_restarts_at_rest : most_restarts_in_motion;
  const Vector start = Vector::Zero(equations.S.rows());
  const Outcome from_elsewhere =
      attempts.solve_from_elsewhere(most_restarts, start, x, response, result);
  if (from_elsewhere == Outcome::stalled && !response.failed)
    result.remark = "neither solved nor proved to have no equilibrium, from " +
                    std::to_string(most_restarts) + " other starts and in " +
                    std::to_string(result.iterations) + " iterations";
  return from_elsewhere;
}

} // namespace frictionbeam::contact
