// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/block_cholesky.h"
#include "analysis/algebra/elastic_operator.h"

namespace frictionbeam {

/**
 * Stiffness of a coarse mesh, assembled and factored by each process as a whole: it is small, and
 * what its solution costs is a sum of one short vector over all processes.
 */
template <int dim>
class CoarseFactorization {
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<float>;

  CoarseFactorization(const ContinuumBody<dim> &body, const dealii::DoFHandler<dim> &dof_handler,
                      const dealii::AffineConstraints<double> &constraints);

  /// Factor the stiffness with contacts' blocks of this process. @return whether it could
  bool factorize(const std::vector<NodeBlock<dim>> &blocks);
  void solve(Vector &x, const Vector &b) const;

private:
  using Sparse = Eigen::SparseMatrix<double>;
  struct Entry {
    unsigned int row, column;
    double value;
    template <class Archive>
    void serialize(Archive &archive, const unsigned int) {
      archive &row &column &value;
    }
  };
  /// The entries of all processes, added up in the lower triangle, in the order of elimination.
  Sparse sum_of_all(const std::vector<Entry> &own) const;

  const MPI_Comm communicator;
  const dealii::IndexSet owned;
  Eigen::VectorXi place; ///< of each dof in the order of elimination
  Sparse stiffness;      ///< lower triangle; 1 on the diagonal of hanging and held dofs
  BlockCholesky factors;
};

} // namespace frictionbeam
