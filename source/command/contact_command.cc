// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/contact_command.h"

#include "base/user_error.h"
#include "results/file/fclib_file.h"

#include <deal.II/base/timer.h>

#include <iostream>
#include <optional>

namespace frictionbeam {

namespace {

void print_residual(const contact::LocalResidual &residual) {
  std::cout << "  natural map ||r - P_K(r - (u + mu |u_T| n))|| / ||q|| = " << residual.natural_map
            << "\n  largest of a contact on its own scale = " << residual.own_scale << " (contact "
            << residual.worst_contact << ", counted from 0)\n";
}

void print_states(const contact::LocalProblem &problem, const Eigen::VectorXd &reactions) {
  unsigned int open = 0, slip = 0;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    const auto r = reactions.segment(problem.dimension * i, problem.dimension);
    if (!(r[0] > 0.))
      ++open;
    else if (r.tail(problem.dimension - 1).norm() >= (1. - 1e-9) * problem.friction[i] * r[0])
      ++slip;
  }
  std::cout << problem.n_contacts() - open - slip << " contacts stick, " << slip
            << " are at the limit of friction, " << open << " carry nothing\n";
}

void print_rank(const contact::LocalProblem &problem) {
  const int rank = contact::estimate_rank(problem);
  if (rank >= 0 && rank < problem.q.size())
    std::cout << "Note: W has rank " << rank << " of " << problem.q.size()
              << " to 1e-12. Where it is singular, as for rigid bodies on more contacts than they "
                 "need, forces are not unique, or there is no solution\n";
}

/// What a solution of the local form leaves of a global problem.
struct GlobalSolution {
  Eigen::VectorXd v;
  double unbalanced; ///< ||M v - H r - f|| / ||f||
  double apart;      ///< ||H^T v + w - (W r + q)|| / ||q||

  bool holds(const double tolerance) const { return unbalanced <= tolerance && apart <= tolerance; }
};

double relative(const Eigen::VectorXd &left, const Eigen::VectorXd &to) {
  const double size = to.norm();
  return left.norm() / (size > 0. ? size : 1.);
}

contact::LocalProblem local_form(const std::string &path, const GlobalContactProblem &problem) {
  const auto condensed = condense(problem);
  if (!condensed)
    throw UserError(
        "The file '" + path +
        "' is not a problem that can be solved: W = H^T M^-1 H does not exist.\n  read: "
        "   M that is singular, to 1e-14, or not positive definite\n  allowed: a body "
        "that is held, or has mass, without its contacts\n  try:     the whole model "
        "with this program, or the contact library (doc/contact_library.md), which "
        "take lines and bodies that rest on contacts alone");
  return *condensed;
}

/// The motions become those of the global form.
GlobalSolution expand(const GlobalContactProblem &global, const contact::LocalProblem &local,
                      contact::LocalSolution &solution) {
  GlobalSolution result{solve_for_motion(global, solution.reactions), 0., 0.};
  const Eigen::VectorXd motions = global.motions(result.v);
  result.unbalanced = relative(global.unbalanced(result.v, solution.reactions), global.f);
  result.apart = relative(motions - solution.motions, local.q);
  solution.motions = motions;
  std::cout << "  left of the global problem: ||M v - H r - f|| / ||f|| = " << result.unbalanced
            << ", ||H^T v + w - (W r + q)|| / ||q|| = " << result.apart << '\n';
  return result;
}

void print_failure(const contact::LocalProblem &problem, const contact::LocalSolution &solution,
                   const ContactOptions &options) {
  const contact::LocalResidual &residual = solution.residual;
  if (solution.out_of_time)
    std::cout << "The time limit of " << options.time_limit << " s was reached\n";
  const double size =
      solution.reactions.segment(problem.dimension * residual.worst_contact, problem.dimension)
          .norm();
  if (residual.natural_map <= options.tolerance)
    std::cout << "By the literature's measure it is solved to " << options.tolerance
              << "; on its own scale contact " << residual.worst_contact << ", whose force is "
              << size / solution.reactions.lpNorm<Eigen::Infinity>()
              << " of the largest, is not. What is written is the best that was found\n";
  else
    std::cout << "The residual is above the tolerance of " << options.tolerance
              << ". What is written is the best that was found; it is not a solution, and there "
                 "may be none\n";
}

void print_outcome(const contact::LocalSolution &solution, const double seconds) {
  std::cout << (solution.converged ? "Solved" : "NOT solved") << " in " << solution.sweeps
            << " sweeps, " << solution.iterations << " iterations, " << solution.outer_iterations
            << " outer ones, " << seconds << " s of computing:\n";
  print_residual(solution.residual);
}

} // namespace

int solve_contact_file(const ContactOptions &options) {
  const std::string &path = options.file;
  try_contact_file(path);
  const ContactProblem read = read_contact_problem(path);
  const auto *const global = std::get_if<GlobalContactProblem>(&read);
  const contact::LocalProblem problem =
      global ? local_form(path, *global) : std::get<contact::LocalProblem>(read);
  std::cout << path << ": ";
  if (global)
    std::cout << "a global problem of " << global->f.size() << " unknowns, ";
  std::cout << problem.n_contacts() << " contacts in " << problem.dimension << "D, W has "
            << problem.W.nonZeros() << " entries in " << problem.q.size() << " rows\n";
  print_rank(problem);
  const auto earlier = read_contact_reactions(path, problem.q.size());
  if (earlier) {
    std::cout << "The solution that the file had:\n";
    print_residual(contact::evaluate_residual(problem, *earlier));
  }
  const dealii::Timer timer;
  contact::LocalSolution solution =
      contact::solve_local_contact(problem, options.tolerance, options.time_limit);
  print_outcome(solution, timer.cpu_time());
  std::optional<Eigen::VectorXd> v;
  if (global) {
    const GlobalSolution whole = expand(*global, problem, solution);
    v = whole.v;
    if (solution.converged && !whole.holds(options.tolerance)) {
      solution.converged = false;
      std::cout << "NOT solved: condensing M to W has lost too many digits\n";
    }
  }
  print_states(problem, solution.reactions);
  const double largest = solution.reactions.lpNorm<Eigen::Infinity>();
  if (earlier && largest > 0.)
    std::cout << "Largest difference to the solution that the file had: "
              << (solution.reactions - *earlier).lpNorm<Eigen::Infinity>() / largest
              << " of the largest force\n";
  if (!solution.converged && !solution.residual.holds(options.tolerance))
    print_failure(problem, solution, options);
  replace_contact_solution(path, solution, v);
  std::cout << "Written to the group /solution of " << path << '\n';
  return solution.converged ? 0 : 2;
}

} // namespace frictionbeam
