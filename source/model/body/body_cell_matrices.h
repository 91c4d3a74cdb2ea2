// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/body.h"

namespace frictionbeam {

/**
 * Stiffness matrices of a body's cells, of the body's own elements or others. Cells with flat
 * faces that differ in place and size only are of one kind: K = (h/h')^(dim-2) K', with the sizes h
 * and the matrix K' of the kind's first cell, which alone is integrated.
 */
template <int dim>
class BodyCellMatrices {
public:
  using Cell = typename dealii::DoFHandler<dim>::cell_iterator;

  BodyCellMatrices(const ContinuumBody<dim> &body, const dealii::FESystem<dim> &fe);

  static constexpr unsigned int no_kind = dealii::numbers::invalid_unsigned_int;
  /// A cell's matrix as a multiple of that of its kind.
  struct Multiple {
    unsigned int kind = no_kind;
    double factor = 1.;
  };
  /// Of a cell that is curved, or whose kind would be one too many: no_kind.
  Multiple kind_of(const Cell &cell);
  unsigned int n_kinds() const { return kinds.size(); }
  const dealii::FullMatrix<double> &of_kind(const unsigned int kind) const {
    return kinds[kind].matrix;
  }
  /// Of any cell, until another one is asked for.
  const dealii::FullMatrix<double> &of(const Cell &cell);

private:
  struct Kind {
    dealii::types::material_id material;
    std::vector<dealii::Tensor<1, dim>> shape; ///< vertices from the first, by the size
    double size;
    dealii::FullMatrix<double> matrix;
  };
  dealii::FullMatrix<double> integrated(const Cell &cell);

  const ContinuumBody<dim> &body;
  const dealii::FESystem<dim> &fe;
  dealii::FEValues<dim> values;
  std::vector<Kind> kinds;
  dealii::FullMatrix<double> present;
};

/// Hand each owned cell's stiffness matrix and dofs to @p add. @param dof_handler of FESystem on
/// the body's mesh or a coarser one
template <int dim>
void assemble_stiffness(
    const ContinuumBody<dim> &body, const dealii::DoFHandler<dim> &dof_handler,
    const std::function<void(const dealii::FullMatrix<double> &,
                             const std::vector<dealii::types::global_dof_index> &)> &add);

/// Call add(row, column, value) for what a cell's matrix gives to free dofs: of hanging ones, those
/// that they hang on have their shares.
template <class Add>
void add_to_free_dofs(const dealii::FullMatrix<double> &local,
                      const std::vector<dealii::types::global_dof_index> &dofs,
                      const dealii::AffineConstraints<double> &constraints, const Add &add) {
  struct Share {
    unsigned int local;
    dealii::types::global_dof_index dof;
    double factor;
  };
  std::vector<Share> shares;
  for (unsigned int i = 0; i < dofs.size(); ++i)
    if (const auto *const masters = constraints.get_constraint_entries(dofs[i])) // of held: none
      for (const auto &[dof, factor] : *masters)
        shares.push_back({i, dof, factor});
    else
      shares.push_back({i, dofs[i], 1.});
  for (const Share &row : shares)
    for (const Share &column : shares)
      add(row.dof, column.dof, row.factor * column.factor * local(row.local, column.local));
}

} // namespace frictionbeam
