// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/vertex_dofs.h>

#include <deal.II/fe/fe.h>
#include <deal.II/grid/tria.h>

namespace frictionbeam {

using namespace dealii;

VertexDofs::VertexDofs(const DoFHandler<1, 3> &dof_handler)
    : dofs(dof_handler.get_triangulation().n_vertices()) {
  for (auto &vertex : dofs)
    vertex.fill(numbers::invalid_dof_index);
  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const unsigned int v : {0u, 1u})
      for (unsigned int i = 0; i < cell->get_fe().n_dofs_per_vertex(); ++i)
        dofs[cell->vertex_index(v)][i] = cell->vertex_dof_index(v, i, cell->active_fe_index());
}

void VertexDofs::constrain(const unsigned int vertex, const std::array<bool, 6> &fixed,
                           AffineConstraints<double> &constraints,
                           const std::array<double, 6> &value) const {
  for (unsigned int c = 0; c < 6; ++c)
    if (fixed[c] && index(vertex, c) != numbers::invalid_dof_index) {
      constraints.add_line(index(vertex, c));
      constraints.set_inhomogeneity(index(vertex, c), value[c]);
    }
}

} // namespace frictionbeam
