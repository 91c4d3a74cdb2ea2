// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/reduced_space.h"
#include <frictionbeam/contact/site.h>
#include <frictionbeam/generalized_strain.h>

namespace frictionbeam {

/// A friction element with its law, ready to be evaluated.
struct Contact : contact::Site {
  using Strains = contact::Strains;

  std::array<unsigned int, 2> vertices{}; ///< pipe, ground
  LocalAxes axes{Vector3({0., 0., -1.})}; ///< x from the pipe to the ground
  std::vector<unsigned int> dofs;         ///< of the cell
  Eigen::Matrix<double, n_support_strains, Eigen::Dynamic> B_dofs; ///< strains of these
  std::vector<int> vertex_unknowns; ///< all free ones of the two vertices
  double platen_force = 0.;         ///< pressed on the ground node [N]
  double restitution = 0.;
  /// Loads that heat its pipe, and by how much at a factor of one [K].
  std::vector<std::pair<unsigned int, double>> heating;
  unsigned int support = 0, site = 0;
  unsigned int place = 0, at = 0; ///< as Site has them
  Vector3 arm;

  /// Of its pipe, at these factors of the loads [degC].
  double temperature(const std::vector<double> &load_factors) const;

  /// Strain at all degrees of freedom.
  Strains strain(const Vector &all_dofs) const;
};

} // namespace frictionbeam
