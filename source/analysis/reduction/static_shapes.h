// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/reduction/line_parts.h"

namespace frictionbeam {

/// Shapes of a part with its border held, orthonormal in K: what its modes and each other leave of
/// the shapes that are added.
class StaticShapes {
public:
  /// @param modes columns, of these stiffnesses x^T K x
  StaticShapes(const LinePart &part, const Eigen::MatrixXd &modes, const Vector &stiffness);

  /**
   * Add what is new in a shape, if anything is.
   * @param norm matrix in which the shape must not vanish
   * @param of norm of what the shape is the difference of, for its rounding error
   */
  void add(Vector shape, const Eigen::SparseMatrix<double> &norm, const double of);

  /// As columns, turned so that they are orthogonal in M as well, with a largest entry of 1.
  Eigen::MatrixXd orthogonal() const;

private:
  const LinePart &part;
  const Eigen::MatrixXd &modes;
  const Vector &stiffness;
  std::vector<Vector> shapes;
};

} // namespace frictionbeam
