// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/coarse_factorization.h"
#include "model/body/body_cell_matrices.h"

namespace frictionbeam {

using namespace dealii;

template <int dim>
CoarseFactorization<dim>::CoarseFactorization(const ContinuumBody<dim> &body,
                                              const DoFHandler<dim> &dof_handler,
                                              const AffineConstraints<double> &constraints)
    : communicator(body.communicator), owned(dof_handler.locally_owned_dofs()) {
  std::vector<Entry> entries;
  assemble_stiffness<dim>(
      body, dof_handler,
      [&](const FullMatrix<double> &local, const std::vector<types::global_dof_index> &dofs) {
        add_to_free_dofs(local, dofs, constraints,
                         [&](const auto row, const auto column, const double value) {
                           if (row >= column)
                             entries.push_back({static_cast<unsigned int>(row),
                                                static_cast<unsigned int>(column), value});
                         });
      });
  for (const auto dof : owned)
    if (constraints.is_constrained(dof))
      entries.push_back({static_cast<unsigned int>(dof), static_cast<unsigned int>(dof), 1.});
  stiffness = sum_of_all(entries);
  factors.analyzePattern(stiffness);
}

template <int dim>
Eigen::SparseMatrix<double>
CoarseFactorization<dim>::sum_of_all(const std::vector<Entry> &own) const {
  std::vector<Eigen::Triplet<double>> triplets;
  for (const auto &part : Utilities::MPI::all_gather(communicator, own))
    for (const Entry &entry : part)
      triplets.emplace_back(entry.row, entry.column, entry.value);
  Sparse sum(owned.size(), owned.size());
  sum.setFromTriplets(triplets.begin(), triplets.end());
  return sum;
}

template <int dim>
bool CoarseFactorization<dim>::factorize(const std::vector<NodeBlock<dim>> &blocks) {
  std::vector<Entry> entries;
  for (const auto &block : blocks)
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        if (block.dofs[a] >= block.dofs[b] && block.stiffness(a, b) != 0.)
          entries.push_back({static_cast<unsigned int>(block.dofs[a]),
                             static_cast<unsigned int>(block.dofs[b]), block.stiffness(a, b)});
  const Sparse sum = stiffness + sum_of_all(entries); // of dofs that a cell couples: its pattern
  factors.factorize(sum);
  return factors.info() == Eigen::Success;
}

template <int dim>
void CoarseFactorization<dim>::solve(Vector &x, const Vector &b) const {
  std::vector<double> right(owned.size(), 0.), all(owned.size());
  for (const auto dof : owned)
    right[dof] = b(dof);
  Utilities::MPI::sum(right, communicator, all);
  const Eigen::VectorXd solution =
      factors.solve(Eigen::Map<const Eigen::VectorXd>(all.data(), all.size()));
  for (const auto dof : owned)
    x(dof) = solution[dof];
}

template class CoarseFactorization<2>;
template class CoarseFactorization<3>;

} // namespace frictionbeam
