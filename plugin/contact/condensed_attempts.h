// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "newton.h"

namespace frictionbeam::contact {

/// What is tried on the contacts of one increment, loads and pose given, one after the other.
class CondensedAttempts {
public:
  CondensedAttempts(IncrementEquations &equations, Newton &newton);

  /**
   * From no motion; where that stalls, something may be free to move; else from forces that balance
   * the loads on motions without strains, which friction may hold by no more than how contacts
   * press on each other; else from elsewhere. A guess of Newton's that nothing holds is decided by
   * the solution with drag.
   */
  Outcome solve(const bool is_static, Vector &x, Response &response, Result &result);
  /**
   * With a drag too small to carry anything: `slides_away` if it is all that holds the loads, else
   * `stalled`.
   */
  Outcome solve_with_drag(Vector &x, Response &response, Result &result);

  /// c that was good the last time.
  double &first_factor() { return attempts.first_factor; }
  double best_factor() const {
    return attempts.first_factor > 0. ? attempts.first_factor : limits.factors[0];
  }

  const AttemptLimits limits;

private:
  Outcome solve_from_balanced_forces(Vector &x, Response &response, Result &result);

  IncrementEquations &equations;
  Newton &newton;
  ProximalSites &proximal;
  Attempts<Newton, ProximalSites> attempts;
};

} // namespace frictionbeam::contact
