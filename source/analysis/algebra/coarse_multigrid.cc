// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/coarse_multigrid.h"
#include "analysis/algebra/smoothed_aggregation.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace frictionbeam {

using namespace dealii;

namespace {

class SerialMultigrid final : public CoarseMultigrid {
public:
  explicit SerialMultigrid(const LinearElements &elements);
  void set_up(const std::vector<Entry> &added) override;
  void cycle(ContinuumVector &x, const ContinuumVector &b) const override;

private:
  using Matrix = SmoothedAggregation::Matrix;

  std::vector<int> unknown_of; ///< by dof; -1: constrained
  std::vector<types::global_dof_index> dof_of;
  std::vector<int> node_begin;
  Eigen::MatrixXd modes;
  Matrix stiffness;
  std::unique_ptr<SmoothedAggregation> multigrid;
  mutable Eigen::VectorXd left, right;
};

SerialMultigrid::SerialMultigrid(const LinearElements &elements)
    : unknown_of(elements.dof_handler.n_dofs(), -1) {
  node_begin.push_back(0);
  for (const auto &cell : elements.dof_handler.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices()) {
      for (unsigned int d = 0; d < 3; ++d) {
        const types::global_dof_index dof = cell->vertex_dof_index(v, d);
        if (unknown_of[dof] < 0 && !elements.constraints.is_constrained(dof)) {
          unknown_of[dof] = dof_of.size();
          dof_of.push_back(dof);
        }
      }
      if (int(dof_of.size()) > node_begin.back())
        node_begin.push_back(dof_of.size());
    }
  const int n = dof_of.size();
  const std::vector<ContinuumVector> motions = elements.rigid_motions();
  modes.resize(n, motions.size());
  for (std::size_t m = 0; m < motions.size(); ++m)
    for (int i = 0; i < n; ++i)
      modes(i, m) = motions[m](dof_of[i]);

  DynamicSparsityPattern pattern(unknown_of.size());
  DoFTools::make_sparsity_pattern(elements.dof_handler, pattern, elements.constraints, false);
  stiffness.resize(n, n);
  std::vector<int> sizes;
  for (const auto dof : dof_of)
    sizes.push_back(pattern.row_length(dof));
  stiffness.reserve(sizes);
  std::vector<int> columns;
  for (int i = 0; i < n; ++i) {
    columns.clear();
    for (auto entry = pattern.begin(dof_of[i]); entry != pattern.end(dof_of[i]); ++entry)
      if (unknown_of[entry->column()] >= 0)
        columns.push_back(unknown_of[entry->column()]);
    std::sort(columns.begin(), columns.end());
    for (const int j : columns)
      stiffness.insert(i, j) = 0.;
  }
  stiffness.makeCompressed();
  struct Share { // of a dof of the cell in an unknown
    unsigned int local;
    int unknown;
    double factor;
  };
  std::vector<Share> shares;
  elements.assemble_stiffness(
      [&](const FullMatrix<double> &local, const std::vector<types::global_dof_index> &dofs) {
        shares.clear();
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (unknown_of[dofs[i]] >= 0)
            shares.push_back({i, unknown_of[dofs[i]], 1.});
          else
            for (const auto &[dof, factor] : *elements.constraints.get_constraint_entries(dofs[i]))
              shares.push_back({i, unknown_of[dof], factor});
        for (const Share &row : shares)
          for (const Share &column : shares)
            stiffness.coeffRef(row.unknown, column.unknown) +=
                row.factor * column.factor * local(row.local, column.local);
      });
}

void SerialMultigrid::set_up(const std::vector<Entry> &added) {
  Matrix matrix = stiffness;
  for (const Entry &entry : added)
    matrix.coeffRef(unknown_of[entry.row], unknown_of[entry.column]) += entry.value;
  multigrid = std::make_unique<SmoothedAggregation>(std::move(matrix), node_begin, modes);
}

void SerialMultigrid::cycle(ContinuumVector &x, const ContinuumVector &b) const {
  right.resize(dof_of.size());
  for (std::size_t i = 0; i < dof_of.size(); ++i)
    right[i] = b.local_element(dof_of[i]);
  multigrid->cycle(left, right);
  x = 0.;
  for (std::size_t i = 0; i < dof_of.size(); ++i)
    x.local_element(dof_of[i]) = left[i];
}

class MlMultigrid final : public CoarseMultigrid {
public:
  MlMultigrid(const LinearElements &elements, const ContinuumBody<3> &body);
  void set_up(const std::vector<Entry> &added) override;
  void cycle(ContinuumVector &x, const ContinuumVector &b) const override { multigrid.vmult(x, b); }

private:
  TrilinosWrappers::SparseMatrix stiffness, matrix;
  std::vector<double> modes; ///< of this process's dofs, one motion after the other
  TrilinosWrappers::PreconditionAMG multigrid;
};

MlMultigrid::MlMultigrid(const LinearElements &elements, const ContinuumBody<3> &body) {
  DynamicSparsityPattern pattern(elements.relevant);
  DoFTools::make_sparsity_pattern(elements.dof_handler, pattern, elements.constraints, false);
  SparsityTools::distribute_sparsity_pattern(pattern, elements.owned, body.communicator,
                                             elements.relevant);
  stiffness.reinit(elements.owned, elements.owned, pattern, body.communicator);
  elements.assemble_stiffness(
      [&](const FullMatrix<double> &local, const std::vector<types::global_dof_index> &dofs) {
        elements.constraints.distribute_local_to_global(local, dofs, stiffness);
      });
  stiffness.compress(VectorOperation::add);
  matrix.copy_from(stiffness);
  for (const ContinuumVector &motion : elements.rigid_motions())
    modes.insert(modes.end(), motion.begin(), motion.end());
}

void MlMultigrid::set_up(const std::vector<Entry> &added) {
  matrix.copy_from(stiffness);
  for (const Entry &entry : added)
    matrix.add(entry.row, entry.column, entry.value);
  matrix.compress(VectorOperation::add);
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("ML output", 0);
  list.set("PDE equations", 3);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", 6);
  list.set("null space: vectors", modes.data());
  list.set("null space: add default vectors", false);
  list.set("aggregation: type", "Uncoupled");
  list.set("aggregation: threshold", 0.02);
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: sweeps", 2);
  list.set("coarse: type", "Amesos-KLU");
  list.set("coarse: max size", 200);
  list.set("initialize random seed", true);
  multigrid.initialize(matrix, list);
}

} // namespace

std::unique_ptr<CoarseMultigrid> make_coarse_multigrid(const LinearElements &elements,
                                                       const ContinuumBody<3> &body) {
  if (body.is_parallel)
    return std::make_unique<MlMultigrid>(elements, body);
  return std::make_unique<SerialMultigrid>(elements);
}

} // namespace frictionbeam
