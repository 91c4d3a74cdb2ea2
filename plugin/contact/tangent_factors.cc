// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tangent_factors.h"

#include <cmath>

namespace frictionbeam::contact {

void TangentFactors::analyze(const SparseMatrix &matrix) {
  constexpr Eigen::Index least_dense = 64; // unknowns
  constexpr double coupled = 0.3;          // of all pairs
  const Eigen::Index n = matrix.rows();
  is_dense = n >= least_dense && matrix.nonZeros() > coupled * n * n;
  if (!is_dense)
    sparse.analyze(matrix);
}

bool TangentFactors::factorize(const SparseMatrix &matrix) {
  if (!is_dense)
    return sparse.factorize(matrix);
  constexpr double vanishes = 1e-15;
  scale = matrix.diagonal().cwiseAbs();
  for (double &s : scale)
    s = s > 0. ? 1. / std::sqrt(s) : 1.;
  dense.compute(scale.asDiagonal() * Eigen::MatrixXd(matrix) * scale.asDiagonal());
  return dense.matrixLU().diagonal().cwiseAbs().minCoeff() > vanishes;
}

Vector TangentFactors::solve(const Vector &right_hand_side) const {
  if (!is_dense)
    return sparse.solve(right_hand_side);
  return scale.cwiseProduct(Vector(dense.solve(scale.cwiseProduct(right_hand_side))));
}

} // namespace frictionbeam::contact
