// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"
#include "model/unknowns/discretization.h"

#include <Eigen/Core>

namespace frictionbeam {

/**
 * By how much a spring or dashpot is extended along its direction @p c: e = w^T u of a few degrees
 * of freedom, those of its point and, with the opposite sign, of its other end. Its force along the
 * direction is k e, on the degrees of freedom k e w.
 * @throws UserError if it turns a point that has no rotations
 */
struct SpringExtension {
  SpringExtension(const Spring &spring, const unsigned int c, const LineMesh &mesh,
                  const VertexDofs &vertex_dofs);

  double of(const Eigen::VectorXd &u) const {
    double e = 0.;
    for (std::size_t i = 0; i < dofs.size(); ++i)
      e += weights[i] * u[dofs[i]];
    return e;
  }
  /// w w^T
  Eigen::MatrixXd unit_stiffness() const { return weights * weights.transpose(); }

  std::vector<dealii::types::global_dof_index> dofs;
  Eigen::VectorXd weights;
};

} // namespace frictionbeam
