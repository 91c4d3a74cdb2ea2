// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/solver.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>
#ifdef DEAL_II_WITH_TRILINOS
#include <deal.II/lac/trilinos_sparse_matrix.h>
#endif

#include <limits>
#include <map>

/**
 * @file
 * What a program of deal.II has, as the contact library wants it. Matrices are those that
 * AffineConstraints::distribute_local_to_global() assembles: rows of constrained degrees of freedom
 * have been eliminated into those they depend on.
 */
namespace frictionbeam::contact {

namespace internal {

/// Number the free dofs, and resolve the others into them.
inline System number_dofs(const dealii::types::global_dof_index n_dofs,
                          const dealii::AffineConstraints<double> &constraints) {
  if (n_dofs > static_cast<dealii::types::global_dof_index>(std::numeric_limits<int>::max()))
    throw std::invalid_argument("A matrix of " + std::to_string(n_dofs) +
                                " rows\n  allowed: 2^31 - 1 of them\n  try:     a System by hand "
                                "of the unknowns near the contacts, condensed by your solver");
  System system;
  std::vector<int> unknown_of(n_dofs, -1);
  for (dealii::types::global_dof_index dof = 0; dof < n_dofs; ++dof)
    if (!constraints.is_constrained(dof)) {
      unknown_of[dof] = system.dof_of.size();
      system.dof_of.push_back(dof);
    }
  system.dofs.resize(n_dofs);
  for (dealii::types::global_dof_index dof = 0; dof < n_dofs; ++dof) {
    System::Resolved &resolved = system.dofs[dof];
    if (unknown_of[dof] >= 0) {
      resolved.terms = {{unknown_of[dof], 1.}};
      continue;
    }
    resolved.given = constraints.get_inhomogeneity(dof);
    for (const auto &[master, weight] : *constraints.get_constraint_entries(dof)) {
      if (unknown_of[master] < 0)
        throw std::invalid_argument("The constraint of dof " + std::to_string(dof) +
                                    " depends on another constrained one\n  allowed: constraints "
                                    "that are closed\n  try:     AffineConstraints::close()");
      resolved.terms.push_back({unknown_of[master], weight});
    }
  }
  return system;
}

inline void set_matrix(const std::vector<Eigen::Triplet<double>> &entries, System &system) {
  system.matrix.resize(system.n_unknowns(), system.n_unknowns());
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  complete(system);
}

/// Places of the free dofs among the unknowns, -1 for constrained ones.
inline int unknown_of(const System &system, const dealii::types::global_dof_index dof) {
  const std::vector<System::Term> &terms = system.dofs[dof].terms;
  return terms.size() == 1 && system.dof_of[terms[0].unknown] == static_cast<int>(dof)
             ? terms[0].unknown
             : -1;
}

} // namespace internal

/// @throws std::invalid_argument as complete(), or if constraints are not closed
inline System system_of(const dealii::SparseMatrix<double> &matrix,
                        const dealii::AffineConstraints<double> &constraints) {
  System system = internal::number_dofs(matrix.m(), constraints);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(matrix.n_nonzero_elements());
  for (const int dof : system.dof_of)
    for (auto entry = matrix.begin(dof); entry != matrix.end(dof); ++entry)
      if (const int column = internal::unknown_of(system, entry->column()); column >= 0)
        entries.emplace_back(internal::unknown_of(system, dof), column, entry->value());
  internal::set_matrix(entries, system);
  return system;
}

#ifdef DEAL_II_WITH_TRILINOS
/**
 * A matrix that is distributed among processes is gathered on each of them, which solve the same
 * problem, so that all get the same answer: for what fits into one. Constraints must be known to
 * every process for all dofs. For more, a System by hand with condense_by_inverse() and the host's
 * own solver.
 */
inline System system_of(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                        const dealii::AffineConstraints<double> &constraints) {
  System system = internal::number_dofs(matrix.m(), constraints);
  std::vector<int> places;
  std::vector<double> values;
  for (const auto row : matrix.locally_owned_range_indices())
    if (const int unknown = internal::unknown_of(system, row); unknown >= 0)
      for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
        if (const int column = internal::unknown_of(system, entry->column()); column >= 0) {
          places.insert(places.end(), {unknown, column});
          values.push_back(entry->value());
        }
  const MPI_Comm communicator = matrix.get_mpi_communicator();
  const auto all_places = dealii::Utilities::MPI::all_gather(communicator, places);
  const auto all_values = dealii::Utilities::MPI::all_gather(communicator, values);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t process = 0; process < all_values.size(); ++process)
    for (std::size_t k = 0; k < all_values[process].size(); ++k)
      entries.emplace_back(all_places[process][2 * k], all_places[process][2 * k + 1],
                           all_values[process][k]);
  internal::set_matrix(entries, system);
  return system;
}
#endif

/// A vector of deal.II on one process, and back.
template <typename VectorType>
Vector to_eigen(const VectorType &vector) {
  Vector result(vector.size());
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result[i] = vector[i];
  return result;
}
template <typename VectorType>
void from_eigen(const Vector &values, VectorType &vector) {
  for (Eigen::Index i = 0; i < values.size(); ++i)
    vector[i] = values[i];
}

namespace internal {

/**
 * Degrees of freedom of @p spacedim components of a cell at one of its vertices, from
 * @p first_component on.
 * @return less if the element has less there
 */
template <typename CellIterator, int spacedim = CellIterator::AccessorType::space_dimension>
std::vector<unsigned int> translations_of_cell(const CellIterator &cell, const unsigned int v,
                                               const unsigned int first_component,
                                               const unsigned int shift) {
  const auto &fe = cell->get_fe();
  std::vector<unsigned int> dofs;
  for (unsigned int d = 0; d < spacedim; ++d)
    for (unsigned int i = 0; i < fe.n_dofs_per_vertex(); ++i) {
      const unsigned int of_cell = v * fe.n_dofs_per_vertex() + i;
      // The functions of a line are of all components, its unknowns in their order.
      const unsigned int component =
          fe.is_primitive(of_cell) ? fe.system_to_component_index(of_cell).first : i;
      if (component == first_component + d) {
        dofs.push_back(shift + cell->vertex_dof_index(v, i, cell->active_fe_index()));
        break;
      }
    }
  return dofs;
}

} // namespace internal

/**
 * Degrees of freedom of the displacement at vertices, dim components, in the numbers of the system,
 * in the order of @p vertices: once over all cells, of which those that know no displacement there
 * (FE_Nothing) are passed over.
 * @param shift of a second handler's dofs behind those of the first
 * @param first_component of the displacement, where others are before it in an FESystem
 * @throws std::invalid_argument if no cell of this process has a vertex and its displacement
 */
template <int dim, int spacedim>
std::vector<std::vector<unsigned int>>
translations_at_vertices(const dealii::DoFHandler<dim, spacedim> &dof_handler,
                         const std::vector<unsigned int> &vertices, const unsigned int shift = 0,
                         const unsigned int first_component = 0) {
  const unsigned int n = dof_handler.get_triangulation().n_vertices();
  std::vector<bool> is_asked(n, false), is_known(n, false);
  for (const unsigned int vertex : vertices)
    if (vertex < n)
      is_asked[vertex] = true;
  std::map<unsigned int, std::vector<unsigned int>> found;
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (cell->is_artificial())
      continue;
    for (const unsigned int v : cell->vertex_indices()) {
      const unsigned int vertex = cell->vertex_index(v);
      if (!is_asked[vertex])
        continue;
      is_known[vertex] = true;
      if (found[vertex].size() < spacedim)
        found[vertex] = internal::translations_of_cell(cell, v, first_component, shift);
    }
  }
  std::vector<std::vector<unsigned int>> dofs;
  for (const unsigned int vertex : vertices) {
    if (vertex >= n || !is_known[vertex])
      throw std::invalid_argument("There is no vertex " + std::to_string(vertex) +
                                  " on this process\n  allowed: vertices of its own cells\n  try:  "
                                  "   cell->vertex_index()");
    if (found[vertex].size() < spacedim)
      throw std::invalid_argument(
          "Vertex " + std::to_string(vertex) + " has " + std::to_string(found[vertex].size()) +
          " degrees of freedom from component " + std::to_string(first_component) +
          " on\n  allowed: " + std::to_string(spacedim) +
          " displacements\n  try:     an element with unknowns at vertices, FESystem(FE_Q(1), " +
          std::to_string(spacedim) + "), and the number of its first component");
    dofs.push_back(found[vertex]);
  }
  return dofs;
}

/// The same for one vertex, which goes over the cells for it alone.
template <int dim, int spacedim>
std::vector<unsigned int>
translations_at_vertex(const dealii::DoFHandler<dim, spacedim> &dof_handler,
                       const unsigned int vertex, const unsigned int shift = 0,
                       const unsigned int first_component = 0) {
  return translations_at_vertices(dof_handler, {vertex}, shift, first_component).front();
}

} // namespace frictionbeam::contact
