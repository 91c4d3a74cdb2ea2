// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <Eigen/Core>

#include <vector>

namespace frictionbeam {

/**
 * A stretch of a pipe whose wall is a solid, as the line sees it: a superelement on the motions q
 * of its sections at the line's vertices, six each, first to last: forces on the sections from
 * outside are K q - sum_l x_l f_l under loads of factors x_l.
 */
struct SolidPart {
  unsigned int pipe = 0, first_cell = 0; ///< in Scene::pipes, in the pipe's chain of cells
  std::vector<unsigned int> vertices;    ///< of the LineMesh, one more than cells
  Eigen::MatrixXd stiffness;             ///< K, global axes
  std::vector<Eigen::VectorXd> forces;   ///< f of each load at factor one [N, N m]
  /// Force and moment about its first vertex of each load at factor one on what lies between two
  /// vertices, by load and cell.
  std::vector<std::vector<Motion>> cell_loads;

  bool has(const unsigned int of_pipe, const unsigned int cell) const {
    return of_pipe == pipe && cell >= first_cell && cell + 1 < first_cell + vertices.size();
  }
};

} // namespace frictionbeam
