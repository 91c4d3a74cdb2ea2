// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <vector>

namespace frictionbeam {

/**
 * The degrees of freedom at the vertices of a line, found in one pass over the cells: what
 * DoFTools::map_dofs_to_support_points and VectorTools::interpolate_boundary_values would be used
 * for, which deal.II 9.4 does not offer for non-primitive elements.
 *
 * On a triangulation that is distributed among processes, those of cells that are not artificial.
 */
class VertexDofs {
public:
  /**
   * @throws dealii::ExcMessage if two lines meet in a vertex and do not share their unknowns there,
   * which is how deal.II joins elements where an FE_Nothing that was made to dominate stands before
   * them in the collection; and as line_part()
   */
  explicit VertexDofs(const dealii::DoFHandler<1, 3> &dof_handler);

  /**
   * Index of component @p component (0..5: ux, uy, uz, rx, ry, rz) at @p vertex, or
   * dealii::numbers::invalid_dof_index if that vertex does not have it. From 6 on: what an FESystem
   * has there besides the line, in its order, a temperature for instance.
   */
  dealii::types::global_dof_index index(const unsigned int vertex,
                                        const unsigned int component) const {
    AssertIndexRange(vertex, dofs.size() / n_at_vertex);
    AssertIndexRange(component, n_at_vertex);
    return dofs[n_at_vertex * vertex + component];
  }

  /// Constrain the components in @p fixed that the vertex has to @p value (0 if not given).
  void constrain(const unsigned int vertex, const std::array<bool, 6> &fixed,
                 dealii::AffineConstraints<double> &constraints,
                 const std::array<double, 6> &value = {}) const;

private:
  unsigned int n_at_vertex = 6;
  std::vector<dealii::types::global_dof_index> dofs; ///< n_at_vertex of each vertex
};

} // namespace frictionbeam
