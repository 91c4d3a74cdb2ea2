// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/tolerances.h>

#include <limits>

namespace frictionbeam::contact {

struct HalvingResult {
  double length, merit;
};

/**
 * Try the lengths 1, 1/2, 1/4, ... of a Newton step, none shorter than @p shortest, until the merit
 * is less than @p before. Where no length does that, a kink lies ahead, and the least bad step
 * crosses it. What go(length) leaves behind is of the length returned.
 * @param go takes the step of a length from its start and returns the merit there
 */
template <typename Go>
HalvingResult search_by_halving(const Go &go, const double before, const double shortest) {
  double best = std::numeric_limits<double>::max(), best_length = 1., length = 1.;
  for (; length >= shortest; length /= 2.) {
    const double after = go(length);
    if (after < best) {
      best = after;
      best_length = length;
    }
    if (after <= (1. - sufficient_decrease * length) * before)
      break;
  }
  return {best_length, length == best_length ? best : go(best_length)};
}

/// A step of Newton's method on motions and contact forces together. @return the merit after it
/// @param n_stalls counts the steps in a row that hardly moved or gained nothing
template <typename Go>
double take_step_of_both(const Go &go, const double before, unsigned int &n_stalls) {
  constexpr double shortest = 1e-3, hardly_moved = 0.01;
  const HalvingResult taken = search_by_halving(go, before, shortest);
  n_stalls = taken.length < hardly_moved || taken.merit > before ? n_stalls + 1 : 0;
  return taken.merit;
}

} // namespace frictionbeam::contact
