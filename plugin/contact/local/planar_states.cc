// SPDX-License-Identifier: LGPL-2.1-or-later
#include "planar_states.h"

#include <Eigen/QR>

#include <vector>

namespace frictionbeam::contact {

bool try_planar_states(const LocalProblem &problem,
                       const std::function<bool(const Eigen::VectorXd &)> &takes) {
  enum State : unsigned int { open, stick, slip_back, slip_on, n_states };
  const unsigned int n = problem.n_contacts();
  const Eigen::MatrixXd W(problem.W);
  unsigned int n_combinations = 1;
  for (unsigned int i = 0; i < n; ++i)
    n_combinations *= n_states;
  for (unsigned int combination = 0; combination < n_combinations; ++combination) {
    std::vector<int> held;                                      // motions that are none
    Eigen::MatrixXd free = Eigen::MatrixXd::Zero(2 * n, 2 * n); // forces that hold them, by columns
    for (unsigned int i = 0, rest = combination; i < n; ++i, rest /= n_states) {
      const unsigned int state = rest % n_states;
      if (state == open)
        continue;
      if (state != stick)
        free(2 * i + 1, held.size()) = (state == slip_on ? -1. : 1.) * problem.friction[i];
      free(2 * i, held.size()) = 1.;
      held.push_back(2 * i);
      if (state != stick)
        continue;
      free(2 * i + 1, held.size()) = 1.;
      held.push_back(2 * i + 1);
    }
    const int m = held.size();
    const Eigen::MatrixXd moved = W * free.leftCols(m);
    Eigen::MatrixXd A(m, m);
    Eigen::VectorXd b(m);
    for (int k = 0; k < m; ++k) {
      A.row(k) = moved.row(held[k]);
      b[k] = -problem.q[held[k]];
    }
    const Eigen::VectorXd sizes = m > 0 ? A.completeOrthogonalDecomposition().solve(b).eval() : b;
    if (takes(free.leftCols(m) * sizes))
      return true;
  }
  return false;
}

} // namespace frictionbeam::contact
