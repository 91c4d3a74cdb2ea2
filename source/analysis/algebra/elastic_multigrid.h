// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/coarse_factorization.h"
#include "analysis/algebra/level_transfer.h"
#include "analysis/algebra/smoother.h"

namespace frictionbeam {

/// Elements, unknowns and operator on one mesh of a multigrid method.
template <int dim>
struct MultigridLevel {
  std::unique_ptr<const dealii::FESystem<dim>> linear;    ///< none on the finest level
  std::unique_ptr<dealii::DoFHandler<dim>> own_numbering; ///< none on the finest level
  const dealii::DoFHandler<dim> *dof_handler = nullptr;
  std::unique_ptr<dealii::AffineConstraints<double>> own_constraints; ///< none on the finest level
  const dealii::AffineConstraints<double> *constraints = nullptr;
  std::vector<std::array<dealii::types::global_dof_index, dim>> contacts; ///< owned, free in part
  std::unique_ptr<ElasticOperator<dim, float>> stiffness;
  std::unique_ptr<ChebyshevSmoother<dim>> smoother;
  LevelTransfer<dim> transfer; ///< from the level below
  mutable dealii::LinearAlgebra::distributed::Vector<float> x, b, residual;
};

/**
 * One V-cycle for the stiffness of a body with its contacts: the body's own elements, linear ones
 * on the same mesh, linear ones on each mesh that is left when all cells are coarsened (global
 * coarsening: P. Munch, T. Heister, L. Prieto Saavedra and M. Kronbichler, ACM Trans. Parallel
 * Comput. 10 (2023) 10), with a factorization on the last. In single precision: it is a
 * preconditioner.
 *
 * A contact's block is a density that goes down to the coarser nodes as forces do (R B 1, with the
 * restriction R), so that each level has blocks at nodes. Linear functions keep it positive.
 */
template <int dim>
class ElasticMultigrid {
public:
  explicit ElasticMultigrid(const ContinuumBody<dim> &body);

  /// @param blocks symmetric and positive, of the body's own contact nodes
  /// @return whether the coarsest stiffness could be factored
  bool take_blocks(const std::vector<NodeBlock<dim>> &blocks);
  /// x = preconditioner times b.
  void vmult(ContinuumVector &x, const ContinuumVector &b) const;

  unsigned int n_levels() const { return levels.size(); }

private:
  using Level = MultigridLevel<dim>;
  void set_up(Level &level, const ContinuumBody<dim> &body, const bool is_finest);
  /// Blocks on the level below @p level of what @p level has.
  std::vector<NodeBlock<dim>> restricted(const Level &level, const Level &below) const;
  void cycle(const unsigned int l) const;

  std::vector<std::shared_ptr<const dealii::Triangulation<dim>>> meshes; ///< coarsest first
  std::vector<Level> levels;                                             ///< coarsest first
  std::unique_ptr<CoarseFactorization<dim>> coarsest;
};

} // namespace frictionbeam
