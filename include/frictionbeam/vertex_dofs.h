// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>

namespace frictionbeam {

/**
 * The degrees of freedom at the vertices of a line, found in one pass over the cells: what
 * DoFTools::map_dofs_to_support_points and VectorTools::interpolate_boundary_values would be used
 * for, which deal.II 9.4 does not offer for non-primitive elements.
 */
class VertexDofs {
public:
  explicit VertexDofs(const dealii::DoFHandler<1, 3> &dof_handler);

  /// Index of component @p component (0..5: ux, uy, uz, rx, ry, rz) at @p vertex, or
  /// dealii::numbers::invalid_dof_index if that vertex does not have it.
  dealii::types::global_dof_index index(const unsigned int vertex,
                                        const unsigned int component) const {
    AssertIndexRange(vertex, dofs.size());
    AssertIndexRange(component, 6);
    return dofs[vertex][component];
  }

  /// Constrain the components in @p fixed that the vertex has to @p value (0 if not given).
  void constrain(const unsigned int vertex, const std::array<bool, 6> &fixed,
                 dealii::AffineConstraints<double> &constraints,
                 const std::array<double, 6> &value = {}) const;

private:
  std::vector<std::array<dealii::types::global_dof_index, 6>> dofs;
};

} // namespace frictionbeam
