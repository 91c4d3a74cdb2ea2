// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/analysis/equilibrium.h>

#include <algorithm>
#include <limits>

namespace frictionbeam {

EquilibriumSolver::EquilibriumSolver(const SolverSettings &settings, const Contacts &contacts,
                                     const ReducedSpace &space)
    : settings(settings), contacts(contacts), space(space) {}

Vector EquilibriumSolver::residual(const EquilibriumProblem &problem, const ContactState &committed,
                                   const Vector &unknowns, const LawTangent tangent,
                                   ContactResponse &response) {
  Vector dofs;
  space.expand(unknowns, dofs);
  dofs += problem.imposed;
  contacts.evaluate(dofs, committed, problem.time, problem.time_increment, tangent, response);
  Vector contact_forces = Vector::Zero(unknowns.size());
  contacts.add_forces(response, contact_forces);
  return problem.right_hand_side - problem.matrix * unknowns - contact_forces;
}

double EquilibriumSolver::tolerance(const EquilibriumProblem &problem, const Vector &unknowns,
                                    const ContactResponse &response) const {
  largest_force = problem.right_hand_side.lpNorm<Eigen::Infinity>();
  for (unsigned int i = 0; i < contacts.size(); ++i)
    largest_force = std::max(largest_force, contacts[i].weight / contacts[i].length *
                                                response.stress[i].lpNorm<Eigen::Infinity>());
  double rounding = 0.;
  if (elastic_diagonal.size() > 0)
    rounding = 8. * std::numeric_limits<double>::epsilon() *
               elastic_diagonal.cwiseProduct(unknowns).lpNorm<Eigen::Infinity>();
  return std::max(settings.tolerance * largest_force, rounding);
}

bool EquilibriumSolver::factor_elastic(const EquilibriumProblem &problem,
                                       const ContactState &committed, const Vector &unknowns,
                                       EquilibriumResult &result) {
  if (elastic_is_current)
    return true;
  if (!analyzed) {
    elastic.analyze(problem.matrix);
    if (settings.method == SolverSettings::Method::newton)
      consistent = elastic;
    analyzed = true;
  }
  ContactResponse response;
  residual(problem, committed, unknowns, LawTangent::elastic, response);
  tangent = problem.matrix;
  contacts.add_tangent(response, tangent);
  elastic_diagonal = tangent.diagonal();
  ++result.factorizations;
  elastic_is_current = elastic.factorize(tangent);
  if (!elastic_is_current)
    result.remark = "the elastic stiffness is singular: something can move freely";
  return elastic_is_current;
}

bool EquilibriumSolver::factor_consistent(const EquilibriumProblem &problem,
                                          const ContactResponse &response,
                                          EquilibriumResult &result) {
  tangent = problem.matrix;
  contacts.add_tangent(response, tangent);
  ++result.factorizations;
  return consistent.factorize(tangent);
}

void EquilibriumSolver::search_line(const EquilibriumProblem &problem,
                                    const ContactState &committed, const Vector &direction,
                                    Vector &unknowns, Vector &forces, ContactResponse &response) {
  // Residuals are weighed by the elastic diagonal: forces and moments become energies.
  const auto merit = [this](const Vector &r) {
    return r.cwiseProduct(r).cwiseQuotient(elastic_diagonal).sum();
  };
  const double before = merit(forces);
  const Vector start = unknowns;
  double best = std::numeric_limits<double>::max(), best_length = 1.;
  for (const double length : {1., 0.5, 0.25, 0.125, 0.0625}) {
    unknowns = start + length * direction;
    forces = residual(problem, committed, unknowns, LawTangent::consistent, response);
    const double after = merit(forces);
    if (after <= (1. - 1e-4 * length) * before)
      return;
    if (after < best) {
      best = after;
      best_length = length;
    }
  }
  // No length decreases the residual: a kink lies ahead, and the least bad step crosses it.
  unknowns = start + best_length * direction;
  forces = residual(problem, committed, unknowns, LawTangent::consistent, response);
}

EquilibriumResult EquilibriumSolver::solve(const EquilibriumProblem &problem,
                                           const ContactState &committed, Vector &unknowns,
                                           ContactResponse &response) {
  EquilibriumResult result;
  if (!factor_elastic(problem, committed, unknowns, result))
    return result;
  const bool newton = settings.method == SolverSettings::Method::newton;
  const unsigned int most = newton ? settings.max_iterations : settings.max_elastic_iterations;
  const LawTangent wanted = newton ? LawTangent::consistent : LawTangent::none;

  Vector forces = residual(problem, committed, unknowns, wanted, response);
  for (;;) {
    const double allowed = tolerance(problem, unknowns, response);
    const double size = forces.lpNorm<Eigen::Infinity>();
    result.residual = largest_force > 0. ? size / largest_force : size;
    if (response.failed) {
      result.remark = "a law had no answer";
      return result;
    }
    if (size <= allowed) {
      result.converged = true;
      return result;
    }
    if (!(size < 1e30)) {
      result.remark = "the iteration diverges";
      return result;
    }
    if (result.iterations == most) {
      result.remark = "no convergence in " + std::to_string(most) + " iterations";
      return result;
    }
    ++result.iterations;
    if (newton && result.iterations > 1) {
      if (!factor_consistent(problem, response, result)) {
        result.remark = "the tangent is singular";
        return result;
      }
      search_line(problem, committed, consistent.solve(forces), unknowns, forces, response);
    } else {
      unknowns += elastic.solve(forces);
      forces = residual(problem, committed, unknowns, wanted, response);
    }
  }
}

} // namespace frictionbeam
