// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact_solver.h"

#include <algorithm>

namespace frictionbeam {

namespace {

constexpr double cautious_factor = 1e-3, bold_factor = 1., largest_factor = 100.,
                 first_growth = 10., least_growth = 2., retreat = 30.;
constexpr unsigned int most_outer = 200, most_failures = 30, most_inner = 15;

} // namespace

ExactSolver::ExactSolver(const SolverSettings &settings, const Contacts &contacts,
                         const ReducedSpace &space, const SparseMatrix &stiffness)
    : settings(settings), contacts(contacts), space(space), proximal(contacts, stiffness) {}

bool ExactSolver::solve_inner(const EquilibriumProblem &problem, Residual &residual,
                              Vector &unknowns, ContactResponse &response,
                              EquilibriumResult &result) {
  Vector forces = residual(unknowns, LawTangent::consistent, response);
  for (unsigned int iteration = 0;; ++iteration) {
    const double size = forces.lpNorm<Eigen::Infinity>();
    const double largest = residual.largest_force(response);
    result.residual = largest > 0. ? size / largest : size;
    if (response.failed || !(size < 1e30)) {
      result.remark = response.failed ? "a law had no answer" : "the iteration diverges";
      return false;
    }
    if (size <= residual.tolerance(settings.tolerance, diagonal, unknowns, response))
      return true;
    last_forces = forces;
    if (iteration == most_inner) {
      result.remark = "no convergence in " + std::to_string(most_inner) + " iterations";
      return false;
    }
    ++result.iterations;
    if (!factor(problem, forces, response, result))
      return false;
    search_line(residual, factors.solve(forces), diagonal, unknowns, forces, response);
  }
}

bool ExactSolver::factor(const EquilibriumProblem &problem, const Vector &forces,
                         const ContactResponse &response, EquilibriumResult &result) {
  tangent = problem.matrix;
  contacts.add_tangent(response, tangent);
  ++result.factorizations;
  if (factors.factorize(tangent))
    return true;
  result.remark = "the tangent is singular";
  if (slides_away(problem, forces, response))
    return false;
  tangent = problem.matrix;
  contacts.add_tangent(response, tangent);
  for (const double shift : {1e-9, 1e-6}) {
    for (int i = 0; i < tangent.rows(); ++i)
      add_to(tangent, i, i, shift * diagonal[i]);
    ++result.factorizations;
    if (factors.factorize(tangent))
      return true;
  }
  return false;
}

bool ExactSolver::slides_away(const EquilibriumProblem &problem, const Vector &forces,
                              const ContactResponse &response) {
  constexpr double shift = 1e-9;
  tangent = problem.matrix;
  for (int i = 0; i < tangent.rows(); ++i)
    add_to(tangent, i, i, shift * diagonal[i]);
  if (!factors.factorize(tangent))
    return false;
  const Vector motion = factors.solve(forces);
  const double work = forces.dot(motion);
  if (!(work > 0.) || motion.dot(problem.matrix * motion) > 1e-3 * work)
    return false;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    Contact::Strains rate = Contact::Strains::Zero();
    for (unsigned int j = 0; j < contacts[i].unknowns.size(); ++j)
      rate += motion[contacts[i].unknowns[j]] * contacts[i].B_reduced.col(j);
    if (!proximal.gives_utmost(i, response, rate))
      return false;
  }
  return true;
}

EquilibriumResult ExactSolver::solve(const EquilibriumProblem &problem,
                                     const ContactState &committed, Vector &unknowns,
                                     ContactResponse &response) {
  EquilibriumResult result;
  if (!analyzed) {
    factors.analyze(problem.matrix);
    diagonal = problem.matrix.diagonal();
    double mean = diagonal.sum() / diagonal.size();
    if (!(mean > 0.))
      mean = 1.;
    for (double &d : diagonal)
      d = d > 0. ? d : mean;
    analyzed = true;
  }
  proximal.begin(committed);
  Residual residual(problem, contacts, space,
                    [&](const Vector &dofs, const LawTangent wanted, ContactResponse &r) {
                      proximal.evaluate(dofs, committed, problem.time, problem.time_increment,
                                        wanted, r);
                    });
  const auto centre_before = proximal.centre;
  const Vector unknowns_before = unknowns;
  std::vector<ContactStatus> status_before;
  double factor = first_factor;
  double growth = first_growth;
  unsigned int failures = 0;
  for (unsigned int outer = 0; outer < most_outer; ++outer) {
    proximal.stiffness_factor = factor;
    Vector trial = unknowns;
    if (!solve_inner(problem, residual, trial, response, result)) {
      if (slides_away(problem, last_forces, response)) {
        result.no_equilibrium = true;
        result.remark = "there is no equilibrium: the loads exceed what friction can hold, and the "
                        "line slides away";
        break;
      }
      if (++failures == most_failures)
        break;
      factor = std::min(cautious_factor, factor / retreat);
      growth = std::max(least_growth, growth / 2.); // next time more slowly
      continue;
    }
    unknowns = trial;
    proximal.centre = response.stress;
    result.check = proximal.check(response, committed);
    if (result.check->natural_map <= settings.contact_tolerance) {
      if (proximal.let_slipping_go(response))
        continue;
      result.converged = true;
      result.remark.clear();
      first_factor = failures == 0 ? std::min(first_growth * first_factor, bold_factor)
                                   : std::max(first_factor / first_growth, cautious_factor);
      return result;
    }
    // Once no contact changes its state any more, what remains is nearly linear.
    const bool settled = response.status == status_before;
    status_before = response.status;
    factor = std::min((settled && failures == 0 ? growth : 1.) * growth * factor, largest_factor);
  }
  first_factor = cautious_factor;
  proximal.centre = centre_before;
  unknowns = unknowns_before;
  return result;
}

} // namespace frictionbeam
