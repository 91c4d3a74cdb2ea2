// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/contact_command.h"

#include "results/file/fclib_file.h"

#include <deal.II/base/timer.h>

#include <iostream>

namespace frictionbeam {

namespace {

constexpr double tolerance = 1e-8;

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

} // namespace

int solve_contact_file(const std::string &path) {
  try_contact_file(path);
  const contact::LocalProblem problem = read_local_contact_problem(path);
  std::cout << path << ": " << problem.n_contacts() << " contacts in " << problem.dimension
            << "D, W has " << problem.W.nonZeros() << " entries in " << problem.q.size()
            << " rows\n";
  print_rank(problem);
  const auto earlier = read_contact_reactions(path, problem.q.size());
  if (earlier) {
    std::cout << "The solution that the file had:\n";
    print_residual(contact::evaluate_residual(problem, *earlier));
  }
  const dealii::Timer timer;
  const contact::LocalSolution solution = contact::solve_local_contact(problem, tolerance);
  std::cout << (solution.converged ? "Solved" : "NOT solved") << " in " << solution.iterations
            << " iterations, " << solution.outer_iterations << " outer ones, " << timer.wall_time()
            << " s:\n";
  print_residual(solution.residual);
  print_states(problem, solution.reactions);
  const double largest = solution.reactions.lpNorm<Eigen::Infinity>();
  if (earlier && largest > 0.)
    std::cout << "Largest difference to the solution that the file had: "
              << (solution.reactions - *earlier).lpNorm<Eigen::Infinity>() / largest
              << " of the largest force\n";
  if (!solution.converged)
    std::cout << "The residual is above the tolerance of " << tolerance
              << ". What is written is the best that was found; it is not a solution, and there "
                 "may be none\n";
  replace_contact_solution(path, solution);
  std::cout << "Written to the group /solution of " << path << '\n';
  return solution.converged ? 0 : 2;
}

} // namespace frictionbeam
