// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/equilibrium.h"

#include <frictionbeam/contact/tolerances.h>

#include <algorithm>
#include <limits>

namespace frictionbeam {

Vector Residual::operator()(const Vector &unknowns, const LawTangent tangent,
                            ContactResponse &response) {
  space.expand(unknowns, dofs);
  dofs += problem.imposed;
  evaluate(dofs, tangent, response);
  return left(unknowns, Vector(), response);
}

double search_line(Residual &residual, const Vector &direction, const Vector &diagonal,
                   Vector &unknowns, Vector &forces, ContactResponse &response) {
  const auto merit = [&](const Vector &r) {
    return r.cwiseProduct(r).cwiseQuotient(diagonal).sum();
  };
  const double before = merit(forces);
  const Vector start = unknowns;
  double best = std::numeric_limits<double>::max(), best_length = 1.;
  for (const double length : {1., 0.5, 0.25, 0.125, 0.0625}) {
    unknowns = start + length * direction;
    forces = residual(unknowns, LawTangent::consistent, response);
    const double after = merit(forces);
    if (after <= (1. - contact::sufficient_decrease * length) * before)
      return after;
    if (after < best) {
      best = after;
      best_length = length;
    }
  }
  unknowns = start + best_length * direction;
  forces = residual(unknowns, LawTangent::consistent, response);
  return best;
}

} // namespace frictionbeam
