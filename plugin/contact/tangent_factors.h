// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_factorization.h"

#include <Eigen/LU>

namespace frictionbeam::contact {

/// Factors of a condensed stiffness with the unsymmetric blocks of its contacts: sparse ones for a
/// line, dense ones for a body, whose contacts are all coupled.
class TangentFactors {
public:
  /// @param changing places of values by which a matrix may differ from this one
  void analyze(const SparseMatrix &matrix, const std::vector<int> &changing);
  bool is_of_body() const { return is_dense; }
  /// With these values there. @return false if a pivot vanishes: no factors then.
  bool factorize(const std::vector<double> &changed);
  /// Of a line: least part that is left of a pivot.
  double least_share() const { return sparse.least_share(); }
  Vector solve(const Vector &right_hand_side) const;

private:
  bool is_dense = false;
  BlockFactorization sparse;
  Eigen::MatrixXd matrix;                  ///< of a body
  std::vector<std::pair<int, int>> places; ///< of what changes in it
  Eigen::PartialPivLU<Eigen::MatrixXd> dense;
  Vector scale; ///< that the dense matrix is multiplied by from both sides
};

} // namespace frictionbeam::contact
