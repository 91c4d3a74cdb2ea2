// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <optional>
#include <unordered_map>

namespace frictionbeam {

/// What an elastic cell without joints answers with, on the motions of its two ends.
struct CellMatrices {
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  using Vector12 = Eigen::Matrix<double, 12, 1>;

  Matrix12 stiffness;
  Eigen::Matrix<double, 12, 3> line_loads; ///< of a unit force per length in each direction
  Vector12 axial_strain, curvature;        ///< of unit free strains
  std::optional<Matrix12> mass;            ///< none where it was not asked for yet
};

/// Those of cells that have been evaluated, by the active index of the first one that is like them.
using KeptMatrices = std::unordered_map<unsigned int, CellMatrices>;

} // namespace frictionbeam
