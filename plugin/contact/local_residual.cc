// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/local_residual.h>

#include "local_law.h"

#include <frictionbeam/disc_projection.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam::contact {

namespace {

/// Nearest point of the cone |z_T| <= mu z_N.
Eigen::VectorXd project_on_cone(const Eigen::VectorXd &z, const double mu) {
  const Eigen::Index n = z.size() - 1;
  const double shear = z.tail(n).norm();
  if (shear <= mu * z[0])
    return z;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(z.size());
  if (mu * shear <= -z[0])
    return result;
  result[0] = (z[0] + mu * shear) / (1. + mu * mu);
  result.tail(n) = mu * result[0] / shear * z.tail(n);
  return result;
}

} // namespace

LocalResidual evaluate_residual(const LocalProblem &problem, const Eigen::VectorXd &reactions) {
  LocalResidual result;
  const unsigned int d = problem.dimension;
  const Eigen::VectorXd motions = problem.W * reactions + problem.q;
  const Eigen::VectorXd stiffness = diagonal_stiffness(problem);
  Eigen::VectorXd scaled = motions, cone = reactions;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    scaled.segment(d * i, d) *= stiffness[d * i];
    Eigen::VectorXd modified = motions.segment(d * i, d);
    modified[0] += problem.friction[i] * modified.tail(d - 1).norm();
    cone.segment(d * i, d) -=
        project_on_cone(reactions.segment(d * i, d) - modified, problem.friction[i]);
  }
  const double size = problem.q.norm();
  result.natural_map = cone.norm() / (size > 0. ? size : 1.);

  LawProjection law;
  law.project(problem, reactions - scaled);
  Eigen::VectorXd rounding = 8. * std::numeric_limits<double>::epsilon() *
                             (problem.W.cwiseAbs() * reactions.cwiseAbs() + problem.q.cwiseAbs());
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
    rounding.segment(d * i, d) *= stiffness[d * i];
  double largest = 0.;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
    largest = std::max(largest, reactions.segment(d * i, d).norm());
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    const double error = std::max(0., (reactions - law.point).segment(d * i, d).norm() -
                                          rounding.segment(d * i, d).norm());
    const double scale = std::max(
        {reactions.segment(d * i, d).norm(), scaled.segment(d * i, d).norm(), 1e-12 * largest});
    if (scale > 0. && !(error / scale <= result.own_scale)) {
      result.own_scale = error / scale;
      result.worst_contact = i;
    }
  }
  return result;
}

int estimate_rank(const LocalProblem &problem, const double tolerance) {
  if (problem.q.size() > 600)
    return -1;
  const Eigen::VectorXd scale = diagonal_stiffness(problem).cwiseSqrt();
  const Eigen::MatrixXd scaled =
      scale.asDiagonal() * Eigen::MatrixXd(problem.W) * scale.asDiagonal();
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  return (values.array() > tolerance * values.maxCoeff()).count();
}

} // namespace frictionbeam::contact
