// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line/pipe_element.h"
#include "model/unknowns/reduced_space.h"
#include "model/unknowns/sparse_matrix.h"

namespace frictionbeam {

/// Mass of a pipe cell, of which the element speaks afterwards. @param lumped its translations
/// alone, half of it at either end [kg]; otherwise the element's consistent mass with rotary
/// inertia.
PipeElement::Matrix12 mass_of_cell(const Discretization::Cell &cell, const bool lumped,
                                   PipeElement &element);

/**
 * Stiffness and mass on all degrees of freedom, those that are held included, without contacts: for
 * what the supports' own motion does to the line. Assembled only where it is asked for; everything
 * else works on the free unknowns (LinearPart).
 */
class FullMatrices {
public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// @param lumped as mass_of_cell() has it. Point masses always.
  FullMatrices(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
               const ReducedSpace &space, const bool lumped);

  const Matrix &stiffness() const { return K; } ///< pipes and springs
  const Matrix &mass() const { return M; }
  const Matrix &unknowns_to_dofs() const { return C; } ///< u = C q + imposed motions

private:
  Matrix K, M, C;
};

} // namespace frictionbeam
