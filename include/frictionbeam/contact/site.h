// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/bound_law.h>
#include <frictionbeam/contact/matrix.h>

#include <vector>

namespace frictionbeam::contact {

/// Strains of a law of kind `support`: along the normal, two across, twist about the normal.
constexpr int n_strains = 4;
using Strains = Eigen::Matrix<double, n_strains, 1>;
using Block = Eigen::Matrix<double, n_strains, n_strains, Eigen::RowMajor>;

/**
 * A place where a body meets the ground or another body, with the law that holds there.
 *
 * The strains are the motion of the second body (or the ground) relative to the first, over a
 * length: `strain = B q`, q the free unknowns; the first is along the normal from the first body to
 * the second and is negative where they are pressed together, the next two are across. The forces
 * on the unknowns are weight B^T stress: a law per piece has weight = length, a law per square
 * metre weight = length times area.
 */
struct Site {
  BoundLaw law;
  double length = 1.;        ///< [m]
  double weight = 1.;        ///< length times how many laws stand there [m]
  std::vector<int> unknowns; ///< free ones that it depends on
  Eigen::Matrix<double, n_strains, Eigen::Dynamic> B; ///< strains by these [1/m, 1/m, 1/m, rad/m]
  unsigned int state_offset = 0;                      ///< of its part in State::internal
  double installation_temperature = 20.; ///< where no increment says another one [degC]

  /// How many times the law stands there.
  double share() const { return weight / length; }
  /// Forces N, T_y, T_z [N] and the moment [N m] that a stress is.
  Strains force(const Strains &stress) const { return share() * stress; }
  /// Largest of these.
  double largest_force(const Strains &stress) const {
    return share() * stress.lpNorm<Eigen::Infinity>();
  }

  Strains strain_by_unknowns(const Vector &values) const {
    return strain_by_unknowns(values, unknowns);
  }
  /// By a vector that has the unknowns at other places.
  Strains strain_by_unknowns(const Vector &values, const std::vector<int> &places) const;
  /// forces += factor weight B^T stress, on the unknowns, or at their places in another vector.
  void add_to(Vector &forces, const Strains &stress, const double factor = 1.) const {
    add_to(forces, stress, factor, unknowns);
  }
  void add_to(Vector &forces, const Strains &stress, const double factor,
              const std::vector<int> &places) const;
};

} // namespace frictionbeam::contact
