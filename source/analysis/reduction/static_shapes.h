// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/reduction/line_parts.h"

namespace frictionbeam {

/// Shapes of a part with its border held, orthonormal in K: what its modes and each other leave of
/// the shapes that are added (doc/dynamics.md, "Reduction to contact nodes and modes").
class StaticShapes {
public:
  /// @param modes columns, of these stiffnesses x^T K x
  StaticShapes(const PartOfLine &part, const Eigen::MatrixXd &modes, const Vector &stiffness);

  /**
   * Add what is new in a shape, if anything is.
   * @param norm matrix in which the shape must not vanish
   * @param of norm of what the shape is the difference of, for its rounding error
   */
  void add(Vector shape, const Eigen::SparseMatrix<double> &norm, const double of);
  /// Add K^-1 f of the loads, and of the inertia of the motions that they impose.
  /// @param acts whether a load does
  void add_loads(const LinearPart &line, const std::vector<bool> &acts);
  /// Add K^-1 (M Psi + M_b): what follows a border that is accelerated.
  void add_border_inertia();
  /// Add what a state of the line is beyond what its border's motions @p border make of it.
  /// @param norm of the part
  void add_state(const Vector &unknowns, const Vector &border,
                 const Eigen::SparseMatrix<double> &norm);

  /// As columns, turned so that they are orthogonal in M as well, with a largest entry of 1.
  Eigen::MatrixXd orthogonal() const;

private:
  const PartOfLine &part;
  const Eigen::MatrixXd &modes;
  const Vector &stiffness;
  std::vector<Vector> shapes;
};

} // namespace frictionbeam
