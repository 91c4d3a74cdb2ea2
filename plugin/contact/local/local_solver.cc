// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/local_solver.h>

#include "clock.h"
#include "gauss_seidel.h"
#include "local_newton.h"
#include "planar_states.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace frictionbeam::contact {

namespace {

using Eigen::VectorXd;

/// Where the methods take turns from.
struct Plan {
  unsigned int first_sweeps;
  double first_factor, least_factor; ///< c
};

/**
 * Gauss-Seidel sweeps and proximal steps of Newton's method, which take turns from one state. The
 * former find quickly what sticks, slips and is open where contacts are coupled loosely; the latter
 * solve what is near, and carry forces over long ways. A step that succeeds moves the centre and
 * makes the next compliance ten times smaller; where one fails, sweeps go on for as much work as
 * Newton's method has had.
 */
template <int d>
class Turns {
public:
  Turns(const LocalProblem &problem, const double tolerance, const double time_limit)
      : problem(problem), tolerance(tolerance), clock(time_limit), W(problem.W),
        gauss_seidel(problem, W), newton(problem, W, clock) {}

  LocalSolution solve();

private:
  void solve_from_rest(const Plan &plan);
  bool is_done() const { return best.converged || clock.is_over(); }
  void sweep(const unsigned int n);
  /// Keep forces if they are the best so far, as they are or cut to what is admissible: a small
  /// force of friction may be beyond its limit by as little as is much to it. @return whether they
  /// are much better
  bool judge(const VectorXd &forces);
  /// Correct what is the best by steps in extended precision, as long as they help.
  void refine();

  const LocalProblem &problem;
  const double tolerance;
  const Clock clock;
  const BlockMatrix<d> W;
  const GaussSeidel<d> gauss_seidel;
  LocalNewton<d> newton;
  VectorXd r;
  LocalSolution best;
};

template <int d>
bool Turns<d>::judge(const VectorXd &forces) {
  const double before = best.residual.own_scale;
  const bool is_first = best.reactions.size() == 0;
  for (const VectorXd &candidate : {forces, admissible(problem, forces)}) {
    const LocalResidual found = evaluate_residual(problem, candidate);
    if (best.reactions.size() > 0 && !(found.own_scale < best.residual.own_scale))
      continue;
    best.reactions = candidate;
    best.residual = found;
    best.converged = found.holds(tolerance);
  }
  return is_first || best.residual.own_scale < before / 2.;
}

template <int d>
void Turns<d>::sweep(const unsigned int n) {
  for (unsigned int k = 0; k < n && !clock.is_over(); ++k)
    gauss_seidel.sweep(r, best.sweeps++ % 2 == 0);
  judge(r);
}

template <int d>
void Turns<d>::refine() {
  constexpr unsigned int most = 4;
  for (unsigned int k = 0; k < most && best.residual.own_scale > 0.; ++k) {
    VectorXd trial = best.reactions;
    if (!newton.refine(trial) || !judge(trial))
      return;
  }
}

template <int d>
void Turns<d>::solve_from_rest(const Plan &plan) {
  constexpr double largest_factor = 1e7, first_growth = 10., least_growth = 2., slowing = 1.5,
                   retreat = 30.;
  constexpr unsigned int most_steps = 1000, most_in_vain = 150, most_iterations = 15,
                         fewest_sweeps = 10;
  r = VectorXd::Zero(problem.q.size());
  sweep(plan.first_sweeps);
  double factor = plan.first_factor, growth = first_growth;
  unsigned int in_vain = 0;
  std::vector<int> states;
  for (unsigned int step = 0; step < most_steps && in_vain < most_in_vain && !is_done(); ++step) {
    ++best.outer_iterations;
    VectorXd trial = r;
    const bool solved = newton.solve(trial, factor, most_iterations);
    bool helps = false;
    if (solved) {
      r = trial;
      helps = judge(r);
      const bool settled = newton.states() == states;
      states = newton.states();
      if (settled && !best.converged)
        refine();
      factor = std::min(growth * factor, largest_factor);
    } else {
      growth = std::max(growth / slowing, least_growth);
      factor = std::max(factor / retreat, plan.least_factor);
    }
    in_vain = helps ? 0 : in_vain + 1;
    if (solved && !helps && factor >= largest_factor)
      factor /= retreat;
    if ((solved && in_vain < 3) || is_done() || plan.first_sweeps == 0)
      continue;
    const double behind = newton.work() / gauss_seidel.work() - best.sweeps;
    if (behind > 0.)
      sweep(std::max(static_cast<unsigned int>(behind), fewest_sweeps));
  }
}

template <int d>
LocalSolution Turns<d>::solve() {
  judge(VectorXd::Zero(problem.q.size()));
  for (const Plan &plan : {Plan{40, 10., 10.}, Plan{0, 1., 1e-12}})
    if (!is_done())
      solve_from_rest(plan);
  if (!is_done() && d == 2 && problem.n_contacts() <= most_planar_contacts)
    try_planar_states(problem, [this](const VectorXd &forces) {
      judge(forces);
      return is_done();
    });
  if (best.converged) // forces become as right as they can be
    refine();
  best.out_of_time = !best.converged && clock.is_over();
  best.iterations = newton.n_iterations();
  best.motions = motions_of(problem, best.reactions);
  return best;
}

void check(const LocalProblem &problem, const double tolerance, const double time_limit) {
  const auto refuse = [](const std::string &read, const std::string &allowed) {
    throw std::invalid_argument(read + "\n  allowed: " + allowed);
  };
  const Eigen::Index d = problem.dimension, n = d * problem.friction.size();
  if (d != 2 && d != 3)
    refuse("A local problem of dimension " + std::to_string(d), "2 or 3");
  if (problem.W.rows() != n || problem.W.cols() != n || problem.q.size() != n)
    refuse("A local problem of " + std::to_string(problem.friction.size()) +
               " contacts with W of " + std::to_string(problem.W.rows()) + " x " +
               std::to_string(problem.W.cols()) + " and q of " + std::to_string(problem.q.size()),
           "the dimension, " + std::to_string(d) + ", times the number of contacts for each, " +
               std::to_string(n));
  if (!problem.q.allFinite() || !problem.friction.allFinite() ||
      (n > 0 && problem.friction.minCoeff() < 0.))
    refuse("A local problem whose q or friction is not a number, or friction below 0",
           "finite numbers, coefficients from 0 on");
  const Eigen::SparseMatrix<double> transposed = problem.W.transpose();
  const double size = problem.W.norm();
  if (!std::isfinite(size) || (problem.W - transposed).norm() > 1e-8 * size)
    refuse("A local problem whose W is not symmetric, or not finite",
           "the symmetric W of u = W r + q");
  if (!(tolerance > 0. && tolerance < 1.))
    refuse("A tolerance of " + std::to_string(tolerance), "above 0 and below 1");
  if (!(time_limit > 0.))
    refuse("A time limit of " + std::to_string(time_limit) + " s", "above 0");
}

} // namespace

LocalSolution solve_local_contact(const LocalProblem &problem, const double tolerance,
                                  const double time_limit) {
  check(problem, tolerance, time_limit);
  return problem.dimension == 2 ? Turns<2>(problem, tolerance, time_limit).solve()
                                : Turns<3>(problem, tolerance, time_limit).solve();
}

} // namespace frictionbeam::contact
