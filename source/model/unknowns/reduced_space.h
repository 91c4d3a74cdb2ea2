// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/discretization.h"
#include "model/unknowns/matrix_entries.h"

namespace frictionbeam {

/**
 * The directions in which a restraint holds its site, orthonormal motions. A guide holds both
 * directions across where the pipe is vertical.
 */
std::vector<dealii::Tensor<1, 6>> held_directions(const Restraint &restraint, const Site &site);

/**
 * The free unknowns q of a scene: what remains of all degrees of freedom u when restraints, the
 * ground and the motions that a plane scene does not have are taken out, u = C q + imposed. Nothing
 * that is constrained is ever solved for.
 */
class ReducedSpace {
public:
  struct Term {
    int unknown;
    double weight;
  };
  struct Terms {
    const Term *first, *last;
    const Term *begin() const { return first; }
    const Term *end() const { return last; }
  };

  ReducedSpace(const Scene &scene, const LineMesh &mesh, const Discretization &discretization);

  /// Other unknowns: the terms of each degree of freedom as given, nothing said of what is held.
  ReducedSpace(const unsigned int n_unknowns, const std::vector<std::vector<Term>> &terms);

  unsigned int n_unknowns() const { return n_free; }
  unsigned int n_dofs() const { return start.size() - 1; }

  /// The unknowns that a degree of freedom depends on (none if it is held).
  Terms terms(const dealii::types::global_dof_index dof) const {
    return {terms_of_all.data() + start[dof], terms_of_all.data() + start[dof + 1]};
  }

  /// C_e^T local C_e of a few degrees of freedom, added to the entries of a matrix.
  void add_local(const Eigen::Ref<const Eigen::MatrixXd> &local,
                 const std::vector<dealii::types::global_dof_index> &dofs,
                 MatrixEntries &entries) const;
  /// The same, to a matrix in whose pattern the unknowns are coupled, but where the local one is
  /// zero.
  void add_local(const Eigen::Ref<const Eigen::MatrixXd> &local,
                 const std::vector<dealii::types::global_dof_index> &dofs,
                 SparseMatrix &matrix) const;

  /// u = C q.
  void expand(const Vector &unknowns, Vector &dofs) const;
  /// r = C^T f.
  Vector restrict_forces(const Vector &dofs) const;

  /// A direction held at a vertex, for the check of mechanisms.
  struct Held {
    unsigned int vertex;
    dealii::Tensor<1, 6> direction;
  };
  const std::vector<Held> &held() const { return rows; }

private:
  unsigned int n_free = 0;
  std::vector<unsigned int> start;
  std::vector<Term> terms_of_all;
  std::vector<Held> rows;
};

} // namespace frictionbeam
