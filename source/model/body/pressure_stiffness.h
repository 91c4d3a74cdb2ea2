// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/bore_loop.h"

#include <functional>

namespace frictionbeam {

/**
 * What pressure adds to the stiffness of a wall, at 1 Pa: the second variation of
 *   int sigma_1 : (grad u)^T grad u / 2 dx - V(u),
 * with the stress sigma_1 of the closed pipe under 1 Pa that nothing else holds, and the volume V
 * within the bore and two caps as it moves, the potential of a pressure that follows the wall. The
 * two are of one size and belong together: with sigma_1 in equilibrium with V' a rigid rotation
 * needs no force, and neither does the bending of a straight pipe, whose wall pulls by as much as
 * the fluid pushes. What is left of a section that ovalises, w = w_n cos n phi without stretch, is
 * (n^2 - 1) pi w_n^2 / 2 per length: what keeps pressed bends round and lets a tube collapse under
 * pressure from outside.
 *
 * Of the stress, what anchors, heat or weight add to it is left out, as beams of small
 * displacements leave out what axial forces do to them in bending; it would be another problem for
 * each state of the supports.
 */
struct PressureStiffness {
  const PipeWall &wall;
  const ContinuumBody<3> &body; ///< of the same mesh, however it is held
  ContinuumVector free_field;   ///< displacement of the free pipe under 1 Pa, of sigma_1 [m]

  using Add = std::function<void(const dealii::FullMatrix<double> &,
                                 const std::vector<dealii::types::global_dof_index> &)>;
  /// Hand on matrices with their dofs, whose sum is symmetric, though none of them is.
  void assemble(const Add &add) const;
  /// S times the free field, on the unconstrained dofs: what it has to be given so that the free
  /// pipe under pressure is strained as far as without S.
  ContinuumVector times_free_field() const;
};

/// Part of a cell: the rows are what its nodes need [m].
class PressureCells {
public:
  explicit PressureCells(const PressureStiffness &of);

  using Cell = dealii::DoFHandler<3>::active_cell_iterator;
  dealii::FullMatrix<double> of_cell(const Cell &cell);

private:
  void add_stress(const Cell &cell, dealii::FullMatrix<double> &matrix);
  void add_bore(const Cell &cell, dealii::FullMatrix<double> &matrix);

  const PressureStiffness &of;
  dealii::FEValues<3> values;
  dealii::FEFaceValues<3> on_bore;
};

/// V' of the bore and its caps: the forces of 1 Pa, on the unconstrained dofs.
ContinuumVector volume_gradient(const PipeWall &wall, const ContinuumBody<3> &body);

} // namespace frictionbeam
