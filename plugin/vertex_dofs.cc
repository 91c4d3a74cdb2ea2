// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_line.h>
#include <frictionbeam/vertex_dofs.h>

#include <deal.II/fe/fe.h>
#include <deal.II/grid/tria.h>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Component of each unknown that an element has at a vertex: the line's, and from 6 on others.
std::vector<unsigned int> components_at_vertex(const FiniteElement<1, 3> &fe) {
  const LinePart part = line_part(fe);
  const bool is_system = fe.n_base_elements() > 1;
  std::vector<unsigned int> components(fe.n_dofs_per_vertex());
  for (unsigned int i = 0, n_others = 0; i < components.size(); ++i)
    if (part.element == nullptr ? !is_system : fe.system_to_base_index(i).first.first == part.base)
      components[i] = part.element == nullptr ? i : fe.system_to_base_index(i).second;
    else
      components[i] = 6 + n_others++;
  return components;
}

std::string not_shared(const DoFHandler<1, 3> &dof_handler, const unsigned int vertex) {
  std::string names;
  for (unsigned int i = 0; i < dof_handler.get_fe_collection().size(); ++i)
    names += (i == 0 ? "" : ", ") + dof_handler.get_fe(i).get_name();
  return "\n  read:    the lines that meet in vertex " + std::to_string(vertex) +
         " do not share their unknowns there; the collection is " + names +
         "\n  allowed: a collection in which no element that is not a line dominates one"
         "\n  try:     FE_Nothing behind the lines, or not made to dominate\n";
}

} // namespace

VertexDofs::VertexDofs(const DoFHandler<1, 3> &dof_handler) {
  std::vector<std::vector<unsigned int>> components;
  for (unsigned int i = 0; i < dof_handler.get_fe_collection().size(); ++i) {
    components.push_back(components_at_vertex(dof_handler.get_fe(i)));
    for (const unsigned int component : components.back())
      n_at_vertex = std::max(n_at_vertex, component + 1);
  }
  dofs.assign(n_at_vertex * dof_handler.get_triangulation().n_vertices(),
              numbers::invalid_dof_index);
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (cell->is_artificial())
      continue;
    const unsigned int fe_index = cell->active_fe_index();
    for (const unsigned int v : {0u, 1u})
      for (unsigned int i = 0; i < components[fe_index].size(); ++i) {
        const unsigned int vertex = cell->vertex_index(v), component = components[fe_index][i];
        const types::global_dof_index found = cell->vertex_dof_index(v, i, fe_index);
        types::global_dof_index &known = dofs[n_at_vertex * vertex + component];
        AssertThrow(component >= 6 || known == numbers::invalid_dof_index || known == found,
                    ExcMessage(not_shared(dof_handler, vertex)));
        known = found;
      }
  }
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
