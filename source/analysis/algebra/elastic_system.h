// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/body.h"

#include <functional>
#include <string>

namespace frictionbeam {

using AddMatrix = std::function<void(const dealii::FullMatrix<double> &,
                                     const std::vector<dealii::types::global_dof_index> &)>;
using AssembleMatrices = std::function<void(const AddMatrix &)>;

/// Symmetric stiffness of a body on its free dofs, and linear systems with it.
class ContinuumSystem {
public:
  /// Tangent of a contact on the dofs of its node, row by row, added to the stiffness.
  struct Block {
    std::vector<dealii::types::global_dof_index> dofs;
    std::vector<double> values;
  };

  virtual ~ContinuumSystem() = default;

  /**
   * Make the stiffness K + p S from now on, with the S that the system was made with, if with any,
   * which waits for this to be factored.
   * @return whether it is positive definite, or at least has no negative eigenvalue while contacts
   * are open; if not, it is K again
   */
  virtual bool stiffen(const double p) {
    Assert(p == 0., dealii::ExcNotImplemented());
    return p == 0.;
  }
  /// S times @p x.
  virtual void multiply_stiffening(const ContinuumVector &, ContinuumVector &y) const { y = 0.; }

  /// Stiffness times @p x; entries of held and hanging dofs are of no meaning.
  virtual void multiply(const ContinuumVector &x, ContinuumVector &y) const = 0;
  /// Diagonal of the stiffness on this process's dofs.
  virtual double diagonal(const dealii::types::global_dof_index dof) const = 0;

  /**
   * Solve (stiffness + blocks) x = b; x is zero at held and hanging dofs.
   * @param blocks of this process's contact nodes, always the same nodes
   * @return whether it could
   */
  virtual bool solve(const std::vector<Block> &blocks, const bool symmetric,
                     const ContinuumVector &b, ContinuumVector &x) = 0;

  /// The same of several b without blocks, at once where that is faster; x takes their place.
  virtual bool solve_all(std::vector<ContinuumVector> &b) {
    for (ContinuumVector &one : b) {
      ContinuumVector x = one;
      if (!solve({}, true, one, x))
        return false;
      one = x;
    }
    return true;
  }

  /// What it is, for the summary.
  virtual std::string name() const = 0;

  /// What has been counted.
  void transfer(Archive &archive) { archive(n_factorizations, most_iterations); }

  unsigned int n_factorizations = 0;
  unsigned int most_iterations = 0; ///< of a Krylov method, for one system
};

/// What Continuum/Linear solver says. Where it leaves it open: multigrid in 3D from 3,000 unknowns
/// on, if the first mesh is coarse (at most 3,000 unknowns of linear elements) and flat; else a
/// factorization, but under mpirun with more than 60,000 unknowns in 2D and 15,000 in 3D amg.
template <int dim>
std::unique_ptr<ContinuumSystem> make_continuum_system(const ContinuumBody<dim> &body);

/**
 * Sparse Cholesky factorization with the dofs of contact nodes last, so that the last block of the
 * factor gives the stiffness condensed to them: a contact's tangent changes a small dense matrix
 * only, and one sparse factorization serves all iterations of a mesh. (A normal along an axis under
 * a prescribed pressure has no tangent and stays among the others.) A multiple of the identity is
 * added on these dofs before and subtracted after, so that the body may be free but for its
 * contacts.
 */
template <int dim>
std::unique_ptr<ContinuumSystem> make_condensed_system(const ContinuumBody<dim> &body);

/// The same of K + p S. @param assemble hands on matrices with their dofs, whose sum is S
std::unique_ptr<ContinuumSystem> make_stiffened_system(const ContinuumBody<3> &body,
                                                       const AssembleMatrices &assemble);

/// Matrix-free, with geometric multigrid (ElasticMultigrid); in serial and distributed.
template <int dim>
std::unique_ptr<ContinuumSystem> make_multigrid_system(const ContinuumBody<dim> &body);

/// Trilinos, distributed. @param direct with KLU, else AMG with CG or GMRES
template <int dim>
std::unique_ptr<ContinuumSystem> make_distributed_system(const ContinuumBody<dim> &body,
                                                         const bool direct);

} // namespace frictionbeam
