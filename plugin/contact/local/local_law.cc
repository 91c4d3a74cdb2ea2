// SPDX-License-Identifier: LGPL-2.1-or-later
#include "local_law.h"

#include <frictionbeam/disc_projection.h>

#include <cmath>

namespace frictionbeam::contact {

void LawProjection::project(const LocalProblem &problem, const Eigen::VectorXd &trial) {
  const unsigned int d = problem.dimension;
  point = Eigen::VectorXd::Zero(trial.size());
  derivative.assign(problem.n_contacts(), Eigen::Matrix3d::Zero());
  state.assign(problem.n_contacts(), 0);
  constexpr double equal[2] = {1., 1.};
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    const double normal = trial[d * i];
    if (!(normal > 0.))
      continue;
    point[d * i] = normal;
    derivative[i](0, 0) = 1.;
    const double radius = problem.friction[i] * normal;
    const double shear[2] = {trial[d * i + 1], d == 3 ? trial[d * i + 2] : 0.};
    if (std::hypot(shear[0], shear[1]) <= radius) {
      state[i] = 1;
      for (unsigned int c = 1; c < d; ++c) {
        point[d * i + c] = shear[c - 1];
        derivative[i](c, c) = 1.;
      }
      continue;
    }
    state[i] = 2;
    if (radius == 0.)
      continue;
    const DiscProjection on_disc(shear, equal, radius);
    for (unsigned int c = 1; c < d; ++c) {
      point[d * i + c] = on_disc.point[c - 1];
      derivative[i](c, 0) = problem.friction[i] * on_disc.by_radius[c - 1];
      for (unsigned int e = 1; e < d; ++e)
        derivative[i](c, e) = on_disc.by_trial[c - 1][e - 1];
    }
  }
}

Eigen::VectorXd admissible(const LocalProblem &problem, const Eigen::VectorXd &forces) {
  LawProjection law;
  law.project(problem, forces);
  return law.point;
}

Eigen::VectorXd diagonal_stiffness(const LocalProblem &problem) {
  const unsigned int d = problem.dimension;
  Eigen::VectorXd diagonal = problem.W.diagonal();
  const double sum = diagonal.sum(), mean = sum > 0. ? sum / diagonal.size() : 1.;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    auto normal = diagonal.segment(d * i, 1), shear = diagonal.segment(d * i + 1, d - 1);
    // One for both tangential directions, or the disc were an ellipse.
    shear.setConstant(shear.maxCoeff());
    if (!(shear[0] > least_compliance))
      shear.setConstant(normal[0] > least_compliance ? normal[0] : mean);
    if (!(normal[0] > least_compliance))
      normal[0] = shear[0];
  }
  return diagonal.cwiseInverse();
}

} // namespace frictionbeam::contact
