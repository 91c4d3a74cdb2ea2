// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/body.h"

#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include <Eigen/SparseCore>

namespace frictionbeam {

/**
 * Interpolation P from linear elements to elements of any degree, on the same mesh or on the one
 * with some of its cells refined once; the restriction is P^T. Under mpirun it is deal.II's
 * MGTwoLevelTransfer. That calls MPI even where there is none: a process by itself has P as a
 * sparse matrix, a row for each free dof.
 */
template <int dim>
class LevelTransfer {
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<float>;
  /// Elements on a mesh.
  struct Space {
    const dealii::DoFHandler<dim> &dof_handler;
    const dealii::AffineConstraints<double> &constraints;
  };

  void reinit(const Space &fine, const Space &coarse, const bool is_same_mesh,
              const bool is_parallel);
  /// fine += P coarse
  void prolongate_and_add(Vector &fine, const Vector &coarse) const;
  /// coarse += P^T fine
  void restrict_and_add(Vector &coarse, const Vector &fine) const;

private:
  void make_matrix(const Space &fine, const Space &coarse);

  std::unique_ptr<dealii::MGTwoLevelTransfer<dim, Vector>> distributed; ///< under mpirun
  Eigen::SparseMatrix<float, Eigen::RowMajor> matrix;                   ///< else
};

} // namespace frictionbeam
