// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

namespace frictionbeam::contact {

/// How an attempt at a problem of exact contact ends.
enum class Outcome { solved, stalled, slides_away };

/// How much is tried.
struct AttemptLimits {
  std::array<double, 4> factors; ///< c of Newton's method on both, in the order of the attempts
  unsigned int most_together;    ///< iterations of each
  unsigned int most_to_finish = 15, most_outer = 60, most_failures = 20; ///< of proximal steps
};

/**
 * How a problem of exact contact is solved by the two Newton's methods that a line and a body have,
 * each on its own unknowns.
 *
 * Newton's method on displacements and contact forces together is tried first, for some values of
 * c, the scale between the two. Where it stalls, a proximal-point iteration takes over: the problem
 * is solved on proximal contacts of stiffness c k_d around the forces of the step before, c grows
 * from step to step and is lowered where the solution fails, and after each step Newton's method on
 * both is tried again (doc/theory.md, "Exact contact").
 *
 * @tparam Newton has solve_together(most, x, response, result), solve_proximal(x, response,
 * result), take_forces_as_centre(response), gives_up(result), agreed(number) between processes
 * @tparam Contacts has stiffness_factor, centre, friction coefficients
 */
template <typename Newton, typename Contacts>
class Attempts {
public:
  Attempts(Newton &newton, Contacts &contacts, const AttemptLimits &limits)
      : newton(newton), contacts(contacts), limits(limits) {}

  /// From x, and the centre that the contacts have.
  template <typename Unknowns, typename Response, typename Result>
  Outcome solve(Unknowns &x, Response &response, Result &result) {
    const auto centre_before = contacts.centre;
    std::array<double, 4> list = limits.factors;
    std::stable_partition(list.begin(), list.end(),
                          [&](const double c) { return c == first_factor; });
    for (const double c : list) {
      contacts.stiffness_factor = c;
      Unknowns trial = x;
      const Outcome outcome = newton.solve_together(limits.most_together, trial, response, result);
      if (outcome == Outcome::solved) {
        x = trial;
        first_factor = c;
      }
      if (outcome != Outcome::stalled || newton.gives_up(result))
        return outcome;
      contacts.centre = centre_before;
    }
    return solve_by_proximal_steps(x, response, result);
  }

  /// The same again and again, from scattered contact forces and by way of less friction: far above
  /// the limit of uniqueness, states that are near in time need not be near each other.
  template <typename Unknowns, typename Response, typename Result>
  Outcome solve_from_elsewhere(const unsigned int most, const Unknowns &start, Unknowns &x,
                               Response &response, Result &result) {
    const std::vector<double> coefficients = contacts.friction_coefficients();
    const auto centre = contacts.centre;
    std::minstd_rand random; // always the same sequence: equal inputs give equal results
    std::uniform_real_distribution<double> portion(0., 1.), multiple(0., 2.);
    Outcome outcome = Outcome::stalled;
    for (unsigned int k = 0; k < most && outcome == Outcome::stalled && !newton.gives_up(result);
         ++k) {
      for (unsigned int i = 0; i < centre.size(); ++i)
        contacts.centre[i] = multiple(random) * centre[i];
      std::vector<double> reduced = coefficients;
      const double share = newton.agreed(portion(random));
      for (double &friction : reduced)
        friction *= share;
      x = start;
      contacts.set_friction_coefficients(reduced);
      solve(x, response, result);
      contacts.set_friction_coefficients(coefficients);
      outcome = solve(x, response, result);
    }
    return outcome;
  }

  double first_factor = 0.; ///< c that was good the last time

private:
  template <typename Unknowns, typename Response, typename Result>
  Outcome solve_by_proximal_steps(Unknowns &x, Response &response, Result &result) {
    constexpr double first_proximal = 1e-3, largest_factor = 100., first_growth = 10.,
                     least_growth = 2., retreat = 30.;
    double factor = first_proximal, growth = first_growth;
    unsigned int failures = 0;
    for (unsigned int outer = 0; outer < limits.most_outer && !newton.gives_up(result); ++outer) {
      contacts.stiffness_factor = factor;
      Unknowns trial = x;
      const Outcome outcome = newton.solve_proximal(trial, response, result);
      if (outcome == Outcome::slides_away)
        return outcome;
      if (outcome == Outcome::stalled) {
        if (++failures == limits.most_failures)
          return outcome;
        factor = std::min(first_proximal, factor / retreat);
        growth = std::max(least_growth, growth / 2.); // next time more slowly
        continue;
      }
      x = trial;
      newton.take_forces_as_centre(response);
      const auto centre = contacts.centre;
      const Outcome finished =
          newton.solve_together(limits.most_to_finish, trial, response, result);
      if (finished == Outcome::solved)
        x = trial;
      if (finished != Outcome::stalled)
        return finished;
      contacts.centre = centre;
      factor = std::min(growth * factor, largest_factor);
    }
    result.remark = "no convergence in " + std::to_string(limits.most_outer) + " proximal steps";
    return Outcome::stalled;
  }

  Newton &newton;
  Contacts &contacts;
  const AttemptLimits limits;
};

} // namespace frictionbeam::contact
