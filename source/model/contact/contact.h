// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/law/bound_law.h"
#include "model/unknowns/reduced_space.h"
#include <frictionbeam/generalized_strain.h>

namespace frictionbeam {

/// A friction element with its law, ready to be evaluated.
struct Contact {
  using Strains = Eigen::Matrix<double, n_support_strains, 1>;

  BoundLaw law;
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
  double installation_temperature = 20.; ///< [degC]
  /// Loads that heat its pipe, and by how much at a factor of one [K].
  std::vector<std::pair<unsigned int, double>> heating;
  unsigned int state_offset = 0, support = 0, site = 0;

  /// How many times the friction element stands there.
  double share() const { return weight / length; }
  /// Forces N, T_y, T_z [N] and the moment [N m] that a stress is.
  Strains force(const Strains &stress) const { return share() * stress; }
  /// Largest of these.
  double largest_force(const Strains &stress) const {
    return share() * stress.lpNorm<Eigen::Infinity>();
  }

  /// Of its pipe, at these factors of the loads [degC].
  double temperature(const std::vector<double> &load_factors) const;

  /// Strain at all degrees of freedom.
  Strains strain(const Vector &all_dofs) const;
  /// Strain by the unknowns alone, or by a vector that has them at other places.
  Strains strain_by_unknowns(const Vector &values) const {
    return strain_by_unknowns(values, unknowns);
  }
  Strains strain_by_unknowns(const Vector &values, const std::vector<int> &places) const;
  /// forces += factor weight B^T stress, on the unknowns, or at their places in another vector.
  void add_to(Vector &forces, const Strains &stress, const double factor = 1.) const {
    add_to(forces, stress, factor, unknowns);
  }
  void add_to(Vector &forces, const Strains &stress, const double factor,
              const std::vector<int> &places) const;
};

} // namespace frictionbeam
