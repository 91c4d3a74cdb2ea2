// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/pipe_wall.h"
#include "model/body/body.h"

namespace frictionbeam {

/**
 * The edge of the bore on one ring of a wall, and the cap that closes the bore there: straight
 * lines from the loop to the mean of its nodes, with which the cap moves. Of a displacement u, mean
 * u_0, and the arms r from the middle, the volume before the cap has the first and second variation
 *   V'(v)    = (v_0 . A + int v . (r x r') ds) / 3,  A = int r x r' ds / 2,
 *   V''(u,v) = (int (u x r' + r x u') . v ds + v_0 . a(u) + u_0 . a(v)) / 3,  a(u) = int u x r' ds,
 * of which the first integral alone is not symmetric: its other part is on the bore
 * (PressureCells).
 */
class BoreLoop {
public:
  BoreLoop(const PipeWall &wall, const ContinuumBody<3> &body, const unsigned int ring);

  /// Of the loop's nodes, three of each.
  const std::vector<dealii::types::global_dof_index> &dofs() const { return unknowns; }
  /// V' at these, and V'', volumes along the pipe being positive [m2, m].
  const dealii::Vector<double> &gradient() const { return first; }
  const dealii::FullMatrix<double> &matrix() const { return second; }

  /// Of V''(u, v) for rigid motions v about the middle: by how much the force of 1 Pa on the cap,
  /// and its moment, differ in the section as it has moved [m2, m3].
  Motion moved_cap(const ContinuumVector &u) const;

private:
  void read_nodes(const PipeWall &wall, const ContinuumBody<3> &body, const unsigned int ring);
  void integrate(const unsigned int degree, const double sign);

  std::vector<dealii::types::global_dof_index> unknowns;
  std::vector<Vector3> arms; ///< of the nodes
  dealii::Vector<double> first;
  dealii::FullMatrix<double> second;
};

} // namespace frictionbeam
