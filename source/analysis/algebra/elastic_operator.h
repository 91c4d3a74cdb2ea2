// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/body.h"
#include "model/body/cell_product.h"

#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <Eigen/Core>

namespace frictionbeam {

/// Stiffness that a contact adds at its node, on free dofs of this process (row by row, [N/m]).
template <int dim>
struct NodeBlock {
  std::array<dealii::types::global_dof_index, dim> dofs;
  Eigen::Matrix<double, dim, dim> stiffness;
};

/**
 * Stiffness of a body of Hooke's law, with contacts' blocks B at nodes, that is never written down:
 * y = K x + B x with K x = sum over cells of int eps(v) : (lambda tr(eps(x)) I + 2 mu eps(x)),
 * a product with one matrix for all cells of a kind (BodyCellMatrices), some at a time; cells of no
 * kind are integrated one by one by sum factorization (M. Kronbichler and K. Kormann, Computers &
 * Fluids 63 (2012) 135-147). Hanging and held dofs are rows of the identity.
 */
template <int dim, typename Number>
class ElasticOperator {
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;

  /// @p dof_handler of FE_Q on the body's mesh or a coarser one
  ElasticOperator(const ContinuumBody<dim> &body, const dealii::DoFHandler<dim> &dof_handler,
                  const dealii::AffineConstraints<double> &constraints);

  void reinit(Vector &vector) const { matrix_free.initialize_dof_vector(vector); }
  /// y = K x + B x
  void vmult(Vector &y, const Vector &x) const;
  /// y = K x
  void multiply_without_blocks(Vector &y, const Vector &x) const;
  /// Of K alone; 1 where a dof is hanging or held.
  const Vector &diagonal() const { return diagonal_of_cells; }
  /// Zero the entries of hanging and held dofs.
  void set_zero_constrained(Vector &vector) const;
  /// B from now on.
  void set_blocks(std::vector<NodeBlock<dim>> those) { blocks = std::move(those); }
  const std::vector<NodeBlock<dim>> &node_blocks() const { return blocks; }

private:
  using Cells = dealii::MatrixFree<dim, Number>;
  using Evaluation = dealii::FEEvaluation<dim, -1, 0, dim, Number>;

  /// Cells of a kind that wait to be multiplied together, with what they read.
  struct Waiting {
    std::vector<unsigned int> batches;
    unsigned int n_cells = 0;
    dealii::AlignedVector<Number> x, y;
  };

  void sort_cells(const ContinuumBody<dim> &body, const dealii::DoFHandler<dim> &dof_handler);
  void apply(const Cells &, Vector &y, const Vector &x,
             const std::pair<unsigned int, unsigned int> &range) const;
  /// Add their products to y, and wait for others.
  void add_products(const unsigned int kind, Waiting &waiting, Evaluation &cell, Vector &y) const;
  void integrate_on_cell(Evaluation &cell) const;

  Cells matrix_free;
  std::vector<CellProduct<Number>> products;            ///< by kind of cell
  std::vector<unsigned int> kinds;                      ///< by batch of cells
  std::vector<dealii::VectorizedArray<Number>> factors; ///< of the kind's matrix, by batch
  std::vector<dealii::VectorizedArray<Number>> lambda,
      two_mu; ///< by batch of cells, times thickness
  Vector diagonal_of_cells;
  std::vector<NodeBlock<dim>> blocks;
};

} // namespace frictionbeam
