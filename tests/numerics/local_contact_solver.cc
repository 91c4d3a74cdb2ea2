// SPDX-License-Identifier: LGPL-2.1-or-later
// One contact by hand: open, sticking, slipping. Random problems by the laws themselves: gaps and
// forces are no less than zero and exclude each other, friction is within the disc, and where it
// slips, at its limit against the slip.
#include "../check.h"

#include <frictionbeam/contact/local_solver.h>

#include <random>

using namespace frictionbeam;
using namespace frictionbeam::contact;

namespace {

contact::LocalProblem one_contact(const Eigen::Vector3d &q) {
  contact::LocalProblem problem;
  problem.W.resize(3, 3);
  problem.W.insert(0, 0) = 2.; // [m/N]
  problem.W.insert(1, 1) = 1.;
  problem.W.insert(2, 2) = 1.;
  problem.q = q;
  problem.friction = Eigen::VectorXd::Constant(1, 0.5);
  return problem;
}

void laws_hold(const contact::LocalProblem &problem, const contact::LocalSolution &solution) {
  CHECK(solution.converged);
  const double most = std::max(solution.reactions.norm(), 1e-30), far = solution.motions.norm();
  for (unsigned int i = 0; i < problem.n_contacts(); ++i) {
    const Eigen::Vector3d r = solution.reactions.segment<3>(3 * i),
                          u = solution.motions.segment<3>(3 * i);
    const Eigen::Vector2d T = r.tail<2>(), slip = u.tail<2>();
    CHECK(r[0] >= -1e-9 * most && u[0] >= -1e-9 * far);
    CHECK(std::abs(r[0] * u[0]) <= 1e-9 * most * far);
    CHECK(T.norm() <= problem.friction[i] * r[0] + 1e-9 * most);
    // least dissipation: T . slip = -mu r_N |slip|
    CHECK_NEAR((T.dot(slip) + problem.friction[i] * r[0] * slip.norm()) / (most * far), 0., 1e-9);
  }
}

contact::LocalProblem random_problem(const unsigned int seed, const int n_contacts) {
  std::minstd_rand random(seed);
  std::normal_distribution<double> number;
  const auto draw = [&](const double) { return number(random); };
  const int n = 3 * n_contacts;
  const Eigen::MatrixXd root = Eigen::MatrixXd(n, n).unaryExpr(draw);
  contact::LocalProblem problem;
  problem.W =
      Eigen::MatrixXd(root * root.transpose() + Eigen::MatrixXd::Identity(n, n)).sparseView();
  problem.q = Eigen::VectorXd(n).unaryExpr(draw);
  problem.friction = Eigen::VectorXd::LinSpaced(n_contacts, 0., 0.6);
  return problem;
}

} // namespace

int main() {
  const auto open = contact::solve_local_contact(one_contact({1., 0.3, 0.}), 1e-12);
  CHECK(open.converged && open.reactions.norm() == 0.);

  // r_N = 2 closes the gap of -4; to hold 0.6 takes T = 0.6 < 0.5 * 2.
  const auto sticks = contact::solve_local_contact(one_contact({-4., 0.6, 0.}), 1e-12);
  CHECK(sticks.converged);
  CHECK_NEAR((sticks.reactions - Eigen::Vector3d(2., -0.6, 0.)).norm(), 0., 1e-12);

  // To hold (3, 4) would take 5 > 1: T = -(3, 4)/5, slip 4/5 of it.
  const auto slips = contact::solve_local_contact(one_contact({-4., 3., 4.}), 1e-12);
  CHECK(slips.converged);
  CHECK_NEAR((slips.reactions - Eigen::Vector3d(2., -0.6, -0.8)).norm(), 0., 1e-12);
  CHECK_NEAR((slips.motions - Eigen::Vector3d(0., 2.4, 3.2)).norm(), 0., 1e-11);

  for (unsigned int seed = 1; seed <= 20; ++seed) {
    const contact::LocalProblem problem = random_problem(seed, 1 + seed % 10);
    laws_hold(problem, contact::solve_local_contact(problem, 1e-10));
  }
  return check::report();
}
