// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_factors.h"
#include "clock.h"
#include "local_law.h"

namespace frictionbeam::contact {

/**
 * Newton's method on the forces of a LocalProblem whose contacts are given a compliance around a
 * centre r_c, D = 1/(c k) with k = 1/W_ii, which adds D (r - r_c) to u:
 *   F(r) = r - P(r - R (W r + q + D (r - r_c))) = 0,
 * P the projection of LawProjection, R a weight. A step solves (I - B + B R (W + D)) dr = -F with
 * P's derivative B on the contacts that are not open; a line search follows. With a large c the
 * compliance only chooses among forces that W, where it is singular, leaves free.
 */
template <int d>
class LocalNewton {
public:
  LocalNewton(const LocalProblem &problem, const BlockMatrix<d> &W, const Clock &clock);

  /// From @p r, which is the centre. @return whether it converged in time; no use is to be made of
  /// r if not
  bool solve(Eigen::VectorXd &r, const double c, const unsigned int most_iterations);

  /// One step with u in extended precision and as good as no compliance: near a solution, forces of
  /// all sizes become as right as they can be. @return false if there is no step
  bool refine(Eigen::VectorXd &r);

  unsigned int n_iterations() const { return iterations; }
  /// Products of blocks so far.
  double work() const { return products; }
  /// 0 open, 1 sticks, 2 slips.
  const std::vector<int> &states() const { return law.state; }

private:
  using Block = typename BlockMatrix<d>::Block;

  void set_centre(const Eigen::VectorXd &r, const double c);
  /// F with u as given; updates the law and the error: F with the weight 1/(W_ii + D), whose
  /// rounding errors are small, relative to the largest force, both times the root of W_ii.
  Eigen::VectorXd residual(const Eigen::VectorXd &r, const Eigen::VectorXd &motions);
  Eigen::VectorXd residual(const Eigen::VectorXd &r) { return residual(r, W.times(r) + problem.q); }
  /// @return whether there is one
  bool step(const Eigen::VectorXd &F, Eigen::VectorXd &change);
  /// Go along the step until F decreases; where no length does that, a kink lies ahead, and the
  /// least bad one crosses it.
  void search(const Eigen::VectorXd &change, Eigen::VectorXd &r, Eigen::VectorXd &F);
  double merit(const Eigen::VectorXd &F) const {
    return F.cwiseProduct(F).cwiseQuotient(stiffness).sum();
  }

  const LocalProblem &problem;
  const BlockMatrix<d> &W;
  const Clock &clock;
  const Eigen::VectorXd stiffness, root; ///< 1/W_ii, sqrt(W_ii)
  Eigen::VectorXd centre, compliance, weight;
  double error = 0., products = 0.;
  unsigned int iterations = 0;
  LawProjection law;
  std::vector<int> closed; ///< contacts that the factors are of
  BlockFactors<d> factors;
};

} // namespace frictionbeam::contact
