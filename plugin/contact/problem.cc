// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/problem.h>
#include <frictionbeam/contact/tolerances.h>

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <vector>

namespace frictionbeam::contact {

std::string too_much_rounding(const double left, const double largest) {
  const auto number = [](const double value) {
    std::ostringstream text;
    if (value >= 100. && value < 1e7)
      text << std::fixed << std::setprecision(0) << value;
    else
      text << std::setprecision(2) << value;
    return text.str();
  };
  return "rounding of the forces, " + number(left) + " N, is too large beside the largest force, " +
         number(largest) + " N";
}

Vector unbalanced_forces(const Problem &problem, const Vector &unknowns, const Vector &low) {
  if (problem.unbalanced)
    return problem.unbalanced(unknowns, low);
  std::vector<long double> whole(unknowns.size());
  for (int i = 0; i < unknowns.size(); ++i)
    whole[i] = static_cast<long double>(unknowns[i]) + low[i];
  const SparseMatrix &matrix = problem.matrix;
  const int *const outer = matrix.outerIndexPtr(), *const inner = matrix.innerIndexPtr(),
                   *const filled = matrix.innerNonZeroPtr(); // null in a compressed matrix
  const double *const values = matrix.valuePtr();
  Vector forces(unknowns.size());
  for (int i = 0; i < matrix.outerSize(); ++i) {
    long double sum = problem.right_hand_side[i], other = 0.; // which need not wait for each other
    int p = outer[i];
    const int end = filled != nullptr ? p + filled[i] : outer[i + 1];
    for (; p + 1 < end; p += 2) {
      sum -= values[p] * whole[inner[p]];
      other += values[p + 1] * whole[inner[p + 1]];
    }
    if (p < end)
      sum -= values[p] * whole[inner[p]];
    forces[i] = static_cast<double>(sum - other);
  }
  return forces;
}

Vector Balance::left(const Vector &unknowns, const Vector &low, const Response &response) const {
  Vector forces = Vector::Zero(unknowns.size());
  sites.add_forces(response, forces);
  if (problem.unbalanced)
    return problem.unbalanced(unknowns, low) - forces;
  if (low.size() == 0)
    return problem.right_hand_side - problem.matrix * unknowns - forces;
  return unbalanced_forces(problem, unknowns, low) - forces;
}

double Balance::largest_force(const Response &response) const {
  return std::max({problem.largest_force, problem.right_hand_side.lpNorm<Eigen::Infinity>(),
                   sites.largest_force(response)});
}

double Balance::rounding(const Vector &diagonal, const Vector &unknowns) {
  return 8. * std::numeric_limits<double>::epsilon() *
         diagonal.cwiseProduct(unknowns).lpNorm<Eigen::Infinity>();
}

double Balance::tolerance(const double relative, const Vector &diagonal, const Vector &unknowns,
                          const Response &response) const {
  // A solution that runs away has rounding errors of any size: they excuse nothing then.
  const double largest = largest_force(response);
  return std::max(relative * largest,
                  std::min(rounding(diagonal, unknowns),
                           most_excused * std::max(largest, problem.force_so_far)));
}

} // namespace frictionbeam::contact
