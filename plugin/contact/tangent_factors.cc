// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tangent_factors.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::contact {

void TangentFactors::analyze(const SparseMatrix &stiffness, const std::vector<int> &changing) {
  constexpr Eigen::Index least_dense = 64; // unknowns
  constexpr double coupled = 0.3;          // of all pairs
  const Eigen::Index n = stiffness.rows();
  is_dense = n >= least_dense && stiffness.nonZeros() > coupled * n * n;
  if (!is_dense) {
    sparse.analyze(stiffness);
    sparse.keep(stiffness, changing);
    return;
  }
  matrix = stiffness;
  const int *const outer = stiffness.outerIndexPtr();
  for (const int place : changing)
    places.emplace_back(std::upper_bound(outer, outer + n, place) - outer - 1,
                        stiffness.innerIndexPtr()[place]);
}

bool TangentFactors::factorize(const std::vector<double> &changed) {
  if (!is_dense)
    return sparse.factorize_changed(changed);
  constexpr double vanishes = 1e-15;
  for (std::size_t k = 0; k < changed.size(); ++k)
    matrix(places[k].first, places[k].second) = changed[k];
  scale = matrix.diagonal().cwiseAbs();
  for (double &s : scale)
    s = s > 0. ? 1. / std::sqrt(s) : 1.;
  dense.compute(scale.asDiagonal() * matrix * scale.asDiagonal());
  return dense.matrixLU().diagonal().cwiseAbs().minCoeff() > vanishes;
}

Vector TangentFactors::solve(const Vector &right_hand_side) const {
  if (!is_dense)
    return sparse.solve(right_hand_side);
  return scale.cwiseProduct(Vector(dense.solve(scale.cwiseProduct(right_hand_side))));
}

} // namespace frictionbeam::contact
