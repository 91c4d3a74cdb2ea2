// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/return_mapping_solver.h"

#include "base/interruption.h"
#include <algorithm>
#include <limits>

namespace frictionbeam {

namespace {

constexpr unsigned int most_at_rounding = 5;
constexpr double most_taken_for_rounding =
    1e-3; ///< of the largest force, that is taken for rounding

} // namespace

ReturnMappingSolver::ReturnMappingSolver(const SolverSettings &settings, const Contacts &contacts,
                                         const ReducedSpace &space)
    : settings(settings), newton(settings.has_tangent()), contacts(contacts), space(space) {}

bool ReturnMappingSolver::factor_elastic(const EquilibriumProblem &problem, Residual &residual,
                                         const Vector &unknowns, EquilibriumResult &result) {
  if (elastic_is_current)
    return true;
  if (!analyzed) {
    elastic.analyze(problem.matrix);
    if (newton)
      consistent = elastic;
    analyzed = true;
  }
  ContactResponse response;
  if (elastic_is_known) // from a checkpoint: it was factored and counted before
    response.tangent = elastic_tangent;
  else {
    residual(unknowns, LawTangent::elastic, response);
    elastic_tangent = response.tangent;
    ++result.factorizations;
  }
  elastic_is_known = false;
  tangent = problem.matrix;
  contacts.add_tangent(response, tangent);
  elastic_diagonal = tangent.diagonal();
  elastic_is_current = elastic.factorize(tangent);
  if (!elastic_is_current)
    result.remark = "the elastic stiffness is singular: something can move freely";
  return elastic_is_current;
}

void ReturnMappingSolver::transfer(Archive &archive) {
  elastic_is_known = elastic_is_known || elastic_is_current;
  archive(elastic_is_known, elastic_tangent);
  if (archive.reads())
    elastic_is_current = false;
}

EquilibriumResult ReturnMappingSolver::solve(const EquilibriumProblem &problem,
                                             const ContactState &committed, Vector &unknowns,
                                             ContactResponse &response) {
  EquilibriumResult result;
  Residual residual(problem, contacts, space,
                    [&](const Vector &dofs, const LawTangent wanted, ContactResponse &r) {
                      contacts.evaluate(dofs, committed, problem.increment, wanted, r);
                    });
  if (!factor_elastic(problem, residual, unknowns, result))
    return result;
  const unsigned int most = newton ? settings.max_iterations : settings.max_elastic_iterations;
  unsigned int n_at_rounding = 0; // iterations one after the other in which nothing is gained
  double size_before = std::numeric_limits<double>::max();
  Vector forces = residual(unknowns, newton ? LawTangent::consistent : LawTangent::none, response);
  for (;;) {
    interruption::end_if_overdue();
    const double size = forces.lpNorm<Eigen::Infinity>();
    const double largest = residual.largest_force(response);
    result.residual = largest > 0. ? size / largest : size;
    result.converged =
        !response.failed &&
        size <= residual.tolerance(settings.tolerance, elastic_diagonal, unknowns, response);
    if (result.converged)
      return result;
    if (response.failed || !(size < 1e30)) {
      result.remark = response.failed ? "a law had no answer" : "the iteration diverges";
      return result;
    }
    const bool at_rounding =
        size <= Residual::rounding(elastic_diagonal, unknowns) &&
        size <= most_taken_for_rounding * std::max(largest, problem.force_so_far);
    n_at_rounding = at_rounding && size > 0.5 * size_before ? n_at_rounding + 1 : 0;
    size_before = size;
    if (n_at_rounding == most_at_rounding) {
      result.rounding_bars = true;
      result.remark =
          contact::too_much_rounding(size, largest) + ": Method = exact knows more digits";
      return result;
    }
    if (result.iterations == std::min(most, problem.most_iterations)) {
      result.remark = "no convergence in " + std::to_string(result.iterations) + " iterations";
      return result;
    }
    if (!improve(problem, residual, forces, unknowns, response, result))
      return result;
  }
}

bool ReturnMappingSolver::improve(const EquilibriumProblem &problem, Residual &residual,
                                  Vector &forces, Vector &unknowns, ContactResponse &response,
                                  EquilibriumResult &result) {
  ++result.iterations;
  ++result.back_substitutions;
  if (!newton || result.iterations == 1) {
    unknowns += elastic.solve(forces);
    forces = residual(unknowns, newton ? LawTangent::consistent : LawTangent::none, response);
    return true;
  }
  tangent = problem.matrix;
  contacts.add_tangent(response, tangent);
  ++result.factorizations;
  if (!consistent.factorize(tangent)) {
    result.remark = "the tangent is singular, as contacts that alone hold something slip or are "
                    "open: Method = exact knows what to do with that";
    return false;
  }
  search_line(residual, consistent.solve(forces), elastic_diagonal, unknowns, forces, response);
  return true;
}

} // namespace frictionbeam
