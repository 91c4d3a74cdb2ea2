// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/local_solver.h>

#include "local_law.h"
#include <frictionbeam/contact/tolerances.h>

#include <Eigen/LU>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace frictionbeam::contact {

namespace {

using Eigen::VectorXd;

constexpr double first_factor = 1., largest_factor = 1e8, least_factor = 1e-12, growth = 10.,
                 retreat = 30., largest_weight = 1e3, inner_tolerance = 1e-12;
constexpr unsigned int most_outer = 300, most_failures = 100, most_inner = 20, most_plain = 10,
                       most_in_vain = 60;

/// W as it is cheapest to factor with.
bool is_dense(const Eigen::SparseMatrix<double> &W) {
  return W.rows() <= 500 || W.nonZeros() > 0.1 * W.rows() * W.cols();
}

class LocalIteration {
public:
  LocalIteration(const LocalProblem &problem, const double tolerance)
      : problem(problem), d(problem.dimension), stiffness(diagonal_stiffness(problem)),
        tolerance(tolerance) {
    if (is_dense(problem.W))
      dense = problem.W;
    centre = VectorXd::Zero(problem.q.size());
  }

  LocalSolution solve();

private:
  /// r - P(r - R (W r + q + D (r - r_c))); updates the law, and the error: the same with
  /// R = 1/(W_ii + D), whose rounding errors are small, relative to the largest force.
  VectorXd residual(const VectorXd &r);
  /// Newton's step from the residual F, with the matrix I - B + B R (W + D), B the law's
  /// derivatives, its rows scaled to size one.
  VectorXd newton_step(const VectorXd &F) const;
  VectorXd dense_step(const VectorXd &F) const;
  VectorXd sparse_step(const VectorXd &F) const;
  double merit(const VectorXd &F) const { return F.cwiseProduct(F).cwiseQuotient(stiffness).sum(); }

  /// Newton's method from @p r. @return whether it converged.
  bool newton(VectorXd &r, const unsigned int most_iterations);
  bool proximal_step(VectorXd &r, const double factor);
  bool plain_steps(VectorXd &r);
  /// Keep @p r if it is the best so far. @return whether to stop: the tolerance is reached, and
  /// more iterations do not help. (Where W is ill-conditioned, forces are known less well than
  /// that.)
  bool judge(const VectorXd &r);

  const LocalProblem &problem;
  const unsigned int d;
  const VectorXd stiffness; ///< 1/W_ii
  const double tolerance;
  Eigen::MatrixXd dense; ///< W; empty if it is treated as sparse
  VectorXd centre;
  VectorXd compliance, weight; ///< D and R
  double error = 0.;
  LawProjection law;
  LocalSolution best;
  unsigned int in_vain = 0; ///< judgements since the best was found
};

VectorXd LocalIteration::residual(const VectorXd &r) {
  const VectorXd u = problem.W * r + problem.q + compliance.cwiseProduct(r - centre);
  law.project(problem, r - (stiffness.cwiseInverse() + compliance).cwiseInverse().cwiseProduct(u));
  const double largest = std::max(r.lpNorm<Eigen::Infinity>(), law.point.lpNorm<Eigen::Infinity>());
  error = (r - law.point).lpNorm<Eigen::Infinity>() / (largest > 0. ? largest : 1.);
  law.project(problem, r - weight.cwiseProduct(u));
  return r - law.point;
}

VectorXd LocalIteration::newton_step(const VectorXd &F) const {
  return dense.size() > 0 ? dense_step(F) : sparse_step(F);
}

VectorXd LocalIteration::dense_step(const VectorXd &F) const {
  const Eigen::Index n = F.size();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n);
  VectorXd right = -F;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    const auto rows = Eigen::seqN(d * i, d);
    const Eigen::MatrixXd B = law.derivative[i].topLeftCorner(d, d);
    const Eigen::MatrixXd BR = B * weight.segment(d * i, d).asDiagonal();
    matrix(rows, Eigen::all).noalias() += BR * dense.middleRows(d * i, d);
    matrix(rows, rows) += BR * compliance.segment(d * i, d).asDiagonal();
    matrix(rows, rows) -= B;
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const double size = matrix.row(i).lpNorm<Eigen::Infinity>();
    if (size > 0.) {
      matrix.row(i) /= size;
      right[i] /= size;
    }
  }
  return matrix.partialPivLu().solve(right);
}

VectorXd LocalIteration::sparse_step(const VectorXd &F) const {
  const Eigen::Index n = F.size();
  std::vector<Eigen::Triplet<double>> blocks, diagonal;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
    for (unsigned int c = 0; c < d; ++c) {
      diagonal.emplace_back(d * i + c, d * i + c, 1.);
      for (unsigned int e = 0; e < d; ++e)
        if (const double b = law.derivative[i](c, e); b != 0.) {
          const unsigned int j = d * i + e;
          blocks.emplace_back(d * i + c, j, b * weight[j]);
          diagonal.emplace_back(d * i + c, j, b * (weight[j] * compliance[j] - 1.));
        }
    }
  Eigen::SparseMatrix<double> BR(n, n), matrix(n, n);
  BR.setFromTriplets(blocks.begin(), blocks.end());
  matrix.setFromTriplets(diagonal.begin(), diagonal.end());
  matrix += Eigen::SparseMatrix<double>(BR * problem.W);
  VectorXd size = VectorXd::Zero(n);
  for (Eigen::Index column = 0; column < n; ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
      size[entry.row()] = std::max(size[entry.row()], std::abs(entry.value()));
  for (double &s : size)
    s = s > 0. ? 1. / s : 1.;
  matrix = size.asDiagonal() * matrix;
  matrix.makeCompressed();
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success)
    return VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
  return factors.solve(VectorXd(-size.cwiseProduct(F)));
}

bool LocalIteration::newton(VectorXd &r, const unsigned int most_iterations) {
  VectorXd F = residual(r);
  double error_before = std::numeric_limits<double>::max();
  for (unsigned int iteration = 0;; ++iteration) {
    if (!(r.lpNorm<Eigen::Infinity>() < 1e100))
      return false;
    // One step at least: with a large c the start is a solution to the tolerance, always. Near the
    // rounding errors, the end is where the error does not fall any more.
    if (iteration > 0 && (error <= inner_tolerance || (error <= 1e-8 && error > error_before / 4.)))
      return true;
    error_before = error;
    if (iteration == most_iterations)
      return false;
    ++best.iterations;
    const VectorXd step = newton_step(F);
    if (!step.allFinite())
      return false;
    // Go on until the residual decreases; where no length does that, a kink lies ahead, and the
    // least bad step crosses it.
    const double before = merit(F);
    double least = std::numeric_limits<double>::max(), best_length = 1.;
    bool decreased = false;
    for (double length = 1.; length > 0.05 && !decreased; length /= 2.) {
      F = residual(r + length * step);
      const double after = merit(F);
      decreased = after <= (1. - sufficient_decrease * length) * before;
      if (after < least) {
        least = after;
        best_length = length;
      }
    }
    r += best_length * step;
    F = residual(r);
  }
}

bool LocalIteration::proximal_step(VectorXd &r, const double factor) {
  compliance = (factor * stiffness).cwiseInverse();
  weight = (compliance + stiffness.cwiseInverse() / largest_weight).cwiseInverse();
  return newton(r, most_inner);
}

bool LocalIteration::plain_steps(VectorXd &r) {
  compliance = VectorXd::Zero(r.size());
  weight = stiffness;
  return newton(r, most_plain);
}

bool LocalIteration::judge(const VectorXd &r) {
  const LocalResidual found = evaluate_residual(problem, r);
  ++in_vain;
  if (best.reactions.size() == 0 || found.own_scale < best.residual.own_scale) {
    in_vain = 0;
    best.reactions = r;
    best.residual = found;
    best.converged = found.own_scale <= tolerance && found.natural_map <= tolerance;
  }
  return best.converged && (in_vain > 3 || found.own_scale == 0.);
}

LocalSolution LocalIteration::solve() {
  VectorXd r = centre;
  bool done = judge(r);
  double factor = first_factor;
  unsigned int failures = 0;
  std::vector<int> state_before;
  while (!done && best.outer_iterations < most_outer && failures < most_failures &&
         in_vain < most_in_vain) {
    ++best.outer_iterations;
    VectorXd trial = r;
    if (!proximal_step(trial, factor)) {
      ++failures;
      factor = std::max(factor / retreat, least_factor);
      continue;
    }
    r = centre = trial;
    done = judge(r);
    const bool settled = law.state == state_before;
    state_before = law.state;
    if (settled && !done && plain_steps(trial))
      done = judge(trial);
    factor = std::min(growth * factor, largest_factor);
  }
  best.motions = problem.W * best.reactions + problem.q;
  return best;
}

} // namespace

namespace {
void check(const LocalProblem &problem, const double tolerance) {
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
}
} // namespace

LocalSolution solve_local_contact(const LocalProblem &problem, const double tolerance) {
  check(problem, tolerance);
  return LocalIteration(problem, tolerance).solve();
}

} // namespace frictionbeam::contact
