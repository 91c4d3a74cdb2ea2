// SPDX-License-Identifier: LGPL-2.1-or-later
#include "local_newton.h"

#include <frictionbeam/contact/local_residual.h>
#include <frictionbeam/contact/tolerances.h>

#include <algorithm>
#include <limits>

namespace frictionbeam::contact {

using Eigen::VectorXd;

template <int d>
LocalNewton<d>::LocalNewton(const LocalProblem &problem, const BlockMatrix<d> &W,
                            const Clock &clock)
    : problem(problem), W(W), clock(clock), stiffness(diagonal_stiffness(problem)),
      root(stiffness.cwiseInverse().cwiseSqrt()) {}

template <int d>
void LocalNewton<d>::set_centre(const VectorXd &r, const double c) {
  constexpr double largest_weight = 1e3;
  centre = r;
  compliance = (c * stiffness).cwiseInverse();
  weight = (compliance + stiffness.cwiseInverse() / largest_weight).cwiseInverse();
}

template <int d>
VectorXd LocalNewton<d>::residual(const VectorXd &r, const VectorXd &motions) {
  products += W.n_blocks() + 15. * W.n_rows();
  const VectorXd u = motions + compliance.cwiseProduct(r - centre);
  law.project(problem, r - (stiffness.cwiseInverse() + compliance).cwiseInverse().cwiseProduct(u));
  const double largest = std::max(r.cwiseProduct(root).template lpNorm<Eigen::Infinity>(),
                                  law.point.cwiseProduct(root).template lpNorm<Eigen::Infinity>());
  error = (r - law.point).cwiseProduct(root).template lpNorm<Eigen::Infinity>() /
          (largest > 0. ? largest : 1.);
  law.project(problem, r - weight.cwiseProduct(u));
  return r - law.point;
}

template <int d>
bool LocalNewton<d>::step(const VectorXd &F, VectorXd &change) {
  const int n = W.n_rows();
  std::vector<int> now_closed;
  for (int i = 0; i < n; ++i)
    if (law.state[i] != 0)
      now_closed.push_back(i);
  if (now_closed != closed) {
    closed = now_closed;
    factors.analyze(W, closed);
    products += 5. * W.n_blocks() + 50. * n;
  }
  std::vector<Block> left(n), diagonal(n);
  change = -F; // is the change of what is open
  for (const int i : closed) {
    const Block B = law.derivative[i].template topLeftCorner<d, d>();
    left[i] = B * weight.segment<d>(d * i).asDiagonal();
    diagonal[i] = Block::Identity() - B + left[i] * compliance.segment<d>(d * i).asDiagonal();
    for (int k = W.begin(i); k < W.begin(i + 1); ++k)
      if (const int j = W.column(k); law.state[j] == 0)
        change.segment<d>(d * i) += left[i] * W.block(k) * F.segment<d>(d * j);
  }
  ++iterations;
  products += factors.work() + 4. * W.n_blocks() + 20. * n; // measured, as are the others
  if (!factors.factorize(W, left, diagonal))
    return false;
  factors.solve(change);
  return change.allFinite();
}

template <int d>
void LocalNewton<d>::search(const VectorXd &change, VectorXd &r, VectorXd &F) {
  constexpr double shortest = 1. / 16.;
  const double before = merit(F);
  double least = std::numeric_limits<double>::max(), best_length = 1.;
  for (double length = 1.; length >= shortest; length /= 2.) {
    F = residual(r + length * change);
    const double after = merit(F);
    if (after <= (1. - sufficient_decrease * length) * before) {
      r += length * change;
      return;
    }
    if (after < least) {
      least = after;
      best_length = length;
    }
  }
  r += best_length * change;
  F = residual(r);
}

template <int d>
bool LocalNewton<d>::solve(VectorXd &r, const double c, const unsigned int most_iterations) {
  constexpr double inner_tolerance = 1e-12, near_rounding = 1e-8, largest_force = 1e100;
  set_centre(r, c);
  VectorXd F = residual(r), change;
  double error_before = std::numeric_limits<double>::max();
  for (unsigned int iteration = 0; iteration < most_iterations && !clock.is_over(); ++iteration) {
    if (!step(F, change))
      return false;
    search(change, r, F);
    if (!(r.lpNorm<Eigen::Infinity>() < largest_force))
      return false;
    // Near the rounding errors, the end is where the error does not fall any more.
    if (error <= inner_tolerance || (error <= near_rounding && error > error_before / 4.))
      return true;
    error_before = error;
  }
  return false;
}

template <int d>
bool LocalNewton<d>::refine(VectorXd &r) {
  constexpr double as_good_as_none = 1e10;
  set_centre(r, as_good_as_none);
  const VectorXd F = residual(r, motions_of(problem, r));
  VectorXd change;
  if (!step(F, change))
    return false;
  r += change;
  return true;
}

template class LocalNewton<2>;
template class LocalNewton<3>;

} // namespace frictionbeam::contact
