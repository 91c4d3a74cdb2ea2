// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/coarse_factorization.h"
#include "model/body/body_cell_matrices.h"

#include <algorithm>

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
  place = Eigen::VectorXi::LinSpaced(owned.size(), 0, owned.size() - 1);
  stiffness = sum_of_all(entries);
  const Eigen::VectorXi order = sparse_order(stiffness, 0);
  for (int i = 0; i < order.size(); ++i)
    place[order[i]] = i;
  stiffness = in_order(stiffness, order);
}

template <int dim>
Eigen::SparseMatrix<double>
CoarseFactorization<dim>::sum_of_all(const std::vector<Entry> &own) const {
  std::vector<Eigen::Triplet<double>> triplets;
  for (const auto &part : Utilities::MPI::all_gather(communicator, own))
    for (const Entry &entry : part) {
      const auto [column, row] = std::minmax(place[entry.row], place[entry.column]);
      triplets.emplace_back(row, column, entry.value);
    }
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
  constexpr double shift = 1e-9; // of a body that nothing holds, whose stiffness has no inverse
  Sparse sum = stiffness + sum_of_all(entries); // of dofs that a cell couples: its pattern
  if (factors.compute(sum, 0))
    return true;
  sum.diagonal() *= 1. + shift;
  return factors.compute(sum, 0);
}

template <int dim>
void CoarseFactorization<dim>::solve(Vector &x, const Vector &b) const {
  std::vector<double> right(owned.size(), 0.), all(owned.size());
  for (const auto dof : owned)
    right[place[dof]] = b(dof);
  Utilities::MPI::sum(right, communicator, all);
  Eigen::MatrixXd solution = Eigen::Map<const Eigen::VectorXd>(all.data(), all.size());
  factors.solve_lower(solution);
  factors.solve_upper(solution);
  for (const auto dof : owned)
    x(dof) = solution(place[dof], 0);
}

template class CoarseFactorization<2>;
template class CoarseFactorization<3>;

} // namespace frictionbeam
