// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/reduced_space.h"
#include <frictionbeam/generalized_strain.h>

namespace frictionbeam {

/// A friction element with its law, ready to be evaluated.
struct Contact {
  using Strains = Eigen::Matrix<double, n_support_strains, 1>;

  const LawDescription *law = nullptr;
  const std::vector<double> *parameters = nullptr;
  std::array<unsigned int, 2> vertices{}; ///< pipe, ground
  LocalAxes axes{Vector3({0., 0., -1.})}; ///< x from the pipe to the ground
  double length = 0.;                     ///< [m]
  double weight = 0.; ///< length times share times tributary length: forces are weight B^T stress
  std::vector<unsigned int> dofs;                             ///< of the cell
  Eigen::Matrix<double, n_support_strains, Eigen::Dynamic> B; ///< strains of these
  std::vector<int> unknowns;                                  ///< free ones they depend on
  std::vector<int> vertex_unknowns;                           ///< all free ones of the two vertices
  Eigen::Matrix<double, n_support_strains, Eigen::Dynamic> B_reduced; ///< strains of those
  double platen_force = 0.; ///< pressed on the ground node [N]
  double restitution = 0.;
  unsigned int state_offset = 0, support = 0, site = 0;

  Strains strain(const Vector &all_dofs) const;
};

} // namespace frictionbeam
