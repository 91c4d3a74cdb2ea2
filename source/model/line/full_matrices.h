// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/reduced_space.h"
#include "model/unknowns/sparse_matrix.h"

namespace frictionbeam {

/**
 * Stiffness and mass on all degrees of freedom, those that are held included, without contacts: for
 * what the supports' own motion does to the line. Assembled only where it is asked for; everything
 * else works on the free unknowns (LinearPart).
 */
class FullMatrices {
public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// @param lumped half of each cell's mass at either end, translations only; otherwise the
  ///   elements' consistent mass with rotary inertia. Point masses always.
  FullMatrices(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
               const ReducedSpace &space, const bool lumped);

  const Matrix &stiffness() const { return K; } ///< pipes and springs
  const Matrix &mass() const { return M; }
  const Matrix &unknowns_to_dofs() const { return C; } ///< u = C q + imposed motions

private:
  Matrix K, M, C;
};

} // namespace frictionbeam
