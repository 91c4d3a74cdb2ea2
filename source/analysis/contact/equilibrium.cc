// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/equilibrium.h"

#include "base/number_text.h"
#include "base/numbers.h"

#include <algorithm>
#include <limits>

namespace frictionbeam {

std::string too_much_rounding(const double left, const double largest) {
  return "rounding of the line's forces, " + rounded_number(left, 2) +
         " N, is too large beside the largest force, " + rounded_number(largest, 2) + " N";
}

Residual::Residual(const EquilibriumProblem &problem, const Contacts &contacts,
                   const ReducedSpace &space, Evaluate evaluate)
    : problem(problem), contacts(contacts), space(space), evaluate(std::move(evaluate)) {}

Vector Residual::operator()(const Vector &unknowns, const LawTangent tangent,
                            ContactResponse &response) {
  space.expand(unknowns, dofs);
  dofs += problem.imposed;
  evaluate(dofs, tangent, response);
  return with_stress(unknowns, Vector(), response);
}

Vector Residual::with_stress(const Vector &unknowns, const Vector &low,
                             const ContactResponse &response) const {
  Vector forces = Vector::Zero(unknowns.size());
  contacts.add_forces(response, forces);
  if (problem.unbalanced)
    return problem.unbalanced(unknowns, low) - forces;
  if (low.size() == 0)
    return problem.right_hand_side - problem.matrix * unknowns - forces;
  return unbalanced_forces(problem, unknowns, low) - forces;
}

Vector unbalanced_forces(const EquilibriumProblem &problem, const Vector &unknowns,
                         const Vector &low) {
  if (problem.unbalanced)
    return problem.unbalanced(unknowns, low);
  Vector forces(unknowns.size());
  for (int i = 0; i < problem.matrix.outerSize(); ++i) {
    long double sum = problem.right_hand_side[i];
    for (SparseMatrix::InnerIterator entry(problem.matrix, i); entry; ++entry)
      sum -= entry.value() * (static_cast<long double>(unknowns[entry.col()]) + low[entry.col()]);
    forces[i] = static_cast<double>(sum);
  }
  return forces;
}

double Residual::largest_force(const ContactResponse &response) const {
  double largest =
      std::max(problem.largest_force, problem.right_hand_side.lpNorm<Eigen::Infinity>());
  for (unsigned int i = 0; i < contacts.size(); ++i)
    largest = std::max(largest, contacts[i].largest_force(response.stress[i]));
  return largest;
}

double Residual::rounding(const Vector &diagonal, const Vector &unknowns) {
  return 8. * std::numeric_limits<double>::epsilon() *
         diagonal.cwiseProduct(unknowns).lpNorm<Eigen::Infinity>();
}

double Residual::tolerance(const double relative, const Vector &diagonal, const Vector &unknowns,
                           const ContactResponse &response) const {
  // A solution that runs away has rounding errors of any size: they excuse nothing then.
  const double largest = largest_force(response);
  return std::max(relative * largest,
                  std::min(rounding(diagonal, unknowns),
                           most_excused * std::max(largest, problem.force_so_far)));
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
    if (after <= (1. - sufficient_decrease * length) * before)
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
