// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/local_residual.h>

#include "local_law.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace frictionbeam::contact {

namespace {

using Eigen::VectorXd;

/// Nearest point of the cone |z_T| <= mu z_N.
template <int d>
Eigen::Matrix<double, d, 1> project_on_cone(const Eigen::Matrix<double, d, 1> &z, const double mu) {
  const double shear = z.template tail<d - 1>().norm();
  if (shear <= mu * z[0])
    return z;
  Eigen::Matrix<double, d, 1> result = Eigen::Matrix<double, d, 1>::Zero();
  if (mu * shear <= -z[0])
    return result;
  result[0] = (z[0] + mu * shear) / (1. + mu * mu);
  result.template tail<d - 1>() = mu * result[0] / shear * z.template tail<d - 1>();
  return result;
}

/// @param size of the terms that each sum has, |W| |r| + |q|
VectorXd sum_up(const LocalProblem &problem, const VectorXd &r, VectorXd &size) {
  const Eigen::SparseMatrix<double> &W = problem.W;
  std::vector<long double> sum(problem.q.data(), problem.q.data() + problem.q.size());
  size = problem.q.cwiseAbs();
  for (Eigen::Index column = 0; column < W.cols(); ++column)
    if (const long double force = r[column]; force != 0.L)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(W, column); entry; ++entry) {
        const long double term = entry.value() * force;
        sum[entry.row()] += term;
        size[entry.row()] += std::abs(static_cast<double>(term));
      }
  VectorXd result(r.size());
  std::copy(sum.begin(), sum.end(), result.data());
  return result;
}

/// Of each contact the largest |q| among all that it is coupled with, itself included: how far its
/// problem has to move.
VectorXd distances(const LocalProblem &problem) {
  const unsigned int d = problem.dimension;
  std::vector<unsigned int> root(problem.n_contacts());
  std::iota(root.begin(), root.end(), 0u);
  const auto root_of = [&](unsigned int i) {
    while (root[i] != i)
      i = root[i] = root[root[i]];
    return i;
  };
  for (Eigen::Index column = 0; column < problem.W.cols(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(problem.W, column); entry; ++entry)
      if (entry.value() != 0.)
        root[root_of(entry.row() / d)] = root_of(column / d);
  VectorXd largest = VectorXd::Zero(problem.n_contacts()), result = largest;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    double &of_all = largest[root_of(i)];
    of_all = std::max(of_all, problem.q.segment(d * i, d).lpNorm<Eigen::Infinity>());
  }
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
    result[i] = largest[root_of(i)];
  return result;
}

template <int d>
LocalResidual residual_of(const LocalProblem &problem, const VectorXd &reactions) {
  using Point = Eigen::Matrix<double, d, 1>;
  constexpr double rounding_factor = 8. * std::numeric_limits<double>::epsilon(), least = 1e-12,
                   most_excused = 1e-3; // of the distance, by rounding
  LocalResidual result;
  VectorXd size;
  const VectorXd motions = sum_up(problem, reactions, size),
                 stiffness = diagonal_stiffness(problem), distance = distances(problem);
  LawProjection law;
  law.project(problem, reactions - stiffness.cwiseProduct(motions));
  double cone = 0., rounding = 0.;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    const double mu = problem.friction[i];
    const Point r = reactions.segment<d>(d * i), u = motions.segment<d>(d * i),
                k = stiffness.segment<d>(d * i), terms = size.segment<d>(d * i);
    Point modified = u;
    modified[0] += mu * u.template tail<d - 1>().norm();
    cone += (r - project_on_cone<d>(r - modified, mu)).squaredNorm();
    rounding += r.squaredNorm() + std::pow((1. + mu) * terms.norm(), 2);

    const Point apart = r - law.point.segment<d>(d * i);
    const double of_terms = k.cwiseProduct(terms).norm(), excused = rounding_factor * terms.norm(),
                 error = std::max(0., apart.norm() - rounding_factor * of_terms),
                 scale = std::max({r.norm(), k.cwiseProduct(u).norm(), least * of_terms}),
                 motion_error = std::max(0., apart.cwiseQuotient(k).norm() -
                                                 std::min(excused, most_excused * distance[i]));
    // Forces may be as large as they like; what they leave of q does not become less by it.
    for (const auto &[left, of] : {std::pair(error, scale), std::pair(motion_error, distance[i])})
      if (of > 0. && !(left / of <= result.own_scale)) {
        result.own_scale = left / of;
        result.worst_contact = i;
      }
  }
  const double q_norm = problem.q.norm(), reference = q_norm > 0. ? q_norm : 1.;
  result.natural_map = std::sqrt(cone) / reference;
  result.rounding = rounding_factor * std::sqrt(rounding) / reference;
  return result;
}

} // namespace

VectorXd motions_of(const LocalProblem &problem, const VectorXd &reactions) {
  VectorXd size;
  return sum_up(problem, reactions, size);
}

LocalResidual evaluate_residual(const LocalProblem &problem, const VectorXd &reactions) {
  return problem.dimension == 2 ? residual_of<2>(problem, reactions)
                                : residual_of<3>(problem, reactions);
}

int estimate_rank(const LocalProblem &problem, const double tolerance) {
  if (problem.q.size() > 600)
    return -1;
  const VectorXd scale = diagonal_stiffness(problem).cwiseSqrt();
  const Eigen::MatrixXd scaled =
      scale.asDiagonal() * Eigen::MatrixXd(problem.W) * scale.asDiagonal();
  const VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  return (values.array() > tolerance * values.maxCoeff()).count();
}

} // namespace frictionbeam::contact
