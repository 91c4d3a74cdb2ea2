// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/body.h"

namespace frictionbeam {

/**
 * Elements of degree one on the mesh of a body of hexahedra, held and hanging as the body is: the
 * space that multigrid goes down to from a higher degree, and what its functions are among the
 * body's.
 */
class LinearElements {
public:
  explicit LinearElements(const ContinuumBody<3> &body);

  void reinit(ContinuumVector &vector) const;
  /// fine += P coarse. @param coarse its ghost values are set here
  void prolongate_add(ContinuumVector &fine, ContinuumVector &coarse) const;
  /// coarse = P^T fine
  void restrict_to(ContinuumVector &coarse, const ContinuumVector &fine) const;

  /// Hand each owned cell's stiffness matrix and dofs to @p add.
  void assemble_stiffness(
      const std::function<void(const dealii::FullMatrix<double> &,
                               const std::vector<dealii::types::global_dof_index> &)> &add) const;

  /// Row of P at a dof of this process's, given by its place in the body's vectors.
  std::vector<std::pair<dealii::types::global_dof_index, double>> row(const unsigned int dof) const;

  /// Three translations and three rotations, about the middle and scaled to the size of the body,
  /// at this process's dofs; zero where they are constrained.
  std::vector<ContinuumVector> rigid_motions() const;

  dealii::DoFHandler<3> dof_handler;
  dealii::AffineConstraints<double> constraints;
  dealii::IndexSet owned, relevant;

private:
  void constrain();
  void interpolate();

  const ContinuumBody<3> &body;
  std::vector<std::size_t> row_begin; ///< of P, at the body's dofs of this process
  std::vector<std::pair<unsigned int, double>> entries; ///< places in vectors of reinit()
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> places;
};

} // namespace frictionbeam
