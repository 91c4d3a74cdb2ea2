// SPDX-License-Identifier: LGPL-2.1-or-later
#include "gauss_seidel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam::contact {

template <int d>
GaussSeidel<d>::GaussSeidel(const LocalProblem &problem, const BlockMatrix<d> &W)
    : problem(problem), W(W) {
  for (int i = 0; i < W.n_rows(); ++i)
    contacts.push_back(alone(W.diagonal(i)));
}

template <int d>
typename GaussSeidel<d>::Alone GaussSeidel<d>::alone(const typename BlockMatrix<d>::Block &W) {
  Alone of;
  of.normal = W(0, 0) > 0. ? 1. / W(0, 0) : 0.;
  const Shear W_TN = W.template bottomLeftCorner<d - 1, 1>();
  of.coupling = of.normal * W_TN;
  const ShearBlock S =
      W.template bottomRightCorner<d - 1, d - 1>() - of.coupling * W_TN.transpose();
  if constexpr (d == 2) {
    of.axes.setOnes();
    of.stiffness = S;
  } else {
    Eigen::SelfAdjointEigenSolver<ShearBlock> eigen;
    eigen.computeDirect(S);
    of.axes = eigen.eigenvectors();
    of.stiffness = eigen.eigenvalues();
  }
  const double least = 1e-12 * W.diagonal().maxCoeff();
  of.stiffness = of.stiffness.cwiseMax(least > 0. ? least : 1.);
  return of;
}

template <int d>
typename GaussSeidel<d>::Point GaussSeidel<d>::solve(const Alone &of, const double friction,
                                                     const Point &q) {
  Point r = Point::Zero();
  if (!(q[0] < 0.) || of.normal == 0.)
    return r;
  const Shear b = of.axes.transpose() * (q.template tail<d - 1>() - of.coupling * q[0]);
  const Shear stick = -b.cwiseQuotient(of.stiffness), coupling = of.axes.transpose() * of.coupling;
  r[0] = -q[0] * of.normal - coupling.dot(stick);
  if (r[0] >= 0. && stick.squaredNorm() <= friction * friction * r[0] * r[0]) {
    r.template tail<d - 1>() = of.axes * stick;
    return r;
  }
  return slip(of, friction, q, b);
}

template <int d>
typename GaussSeidel<d>::Point GaussSeidel<d>::slip(const Alone &of, const double friction,
                                                    const Point &q, const Shear &b) {
  const double pressed = -q[0] * of.normal;
  Point r = Point::Zero();
  if (friction == 0.) {
    r[0] = pressed;
  } else if constexpr (d == 2) {
    const double way = b[0] > 0. ? -friction : friction; // r_T / r_N
    r[0] = std::max(0., pressed / (1. + way * of.coupling[0]));
    r[1] = way * r[0];
  } else {
    const Shear coupling = of.axes.transpose() * of.coupling,
                shear = find_shear(of, friction, pressed, coupling, b);
    r[0] = std::max(0., pressed - coupling.dot(shear));
    const double size = shear.norm();
    if (size > 0.)
      r.template tail<d - 1>() = of.axes * shear * (friction * r[0] / size);
  }
  return r;
}

template <int d>
typename GaussSeidel<d>::Shear GaussSeidel<d>::find_shear(const Alone &of, const double friction,
                                                          const double pressed,
                                                          const Shear &coupling, const Shear &b) {
  constexpr int most_iterations = 60;
  constexpr double exact = 1e-15;
  // |r_T| - mu r_N is above zero at alpha = 0 and below as alpha grows: Newton's method, on 1/|r_T|
  // where that is nearly linear in alpha, kept within what encloses the root.
  double low = 0., high = std::numeric_limits<double>::infinity(), alpha = 0.;
  Shear shear;
  for (int k = 0; k < most_iterations; ++k) {
    const Shear a = of.stiffness.array() + alpha;
    shear = -b.cwiseQuotient(a);
    const double size = shear.norm(), limit = friction * (pressed - coupling.dot(shear)),
                 excess = size - limit;
    if (std::abs(excess) <= exact * size)
      break;
    (excess > 0. ? low : high) = alpha;
    const Shear slope = -shear.cwiseQuotient(a); // by alpha
    const double of_excess = shear.dot(slope) / size + friction * coupling.dot(slope);
    double next = alpha - excess / of_excess * (limit > 0. ? size / limit : 1.);
    if (!(next > low && next < high))
      next = std::isfinite(high) ? (low + high) / 2. : 2. * alpha + of.stiffness.maxCoeff();
    if (next == alpha)
      break;
    alpha = next;
  }
  return shear;
}

template <int d>
void GaussSeidel<d>::sweep(Eigen::VectorXd &r, const bool forwards) const {
  const int n = W.n_rows();
  for (int k = 0; k < n; ++k) {
    const int i = forwards ? k : n - 1 - k;
    auto own = r.template segment<d>(d * i);
    const Point before = own;
    const Point q =
        problem.q.template segment<d>(d * i) + W.row_times(i, r) - W.diagonal(i) * before;
    own = solve(contacts[i], problem.friction[i], q);
  }
}

template class GaussSeidel<2>;
template class GaussSeidel<3>;

} // namespace frictionbeam::contact
