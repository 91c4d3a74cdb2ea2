// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/elastic_system.h"
#include "model/body/pressure_stiffness.h"

#include <Eigen/Core>

#include <algorithm>

namespace frictionbeam {

/**
 * The displacements of a wall under several forces, (K + p S) u = f, at any pressure p. They are
 * solved for without pressure and at the pressures given; between these K + p S is taken on all
 * that they span (Galerkin), whose vectors phi are such that K is 1 and S is diagonal there:
 *   u(p) = sum_j phi_j (phi_j . f)/(1 + p theta_j).
 * At the pressures given the solution itself is taken; between them work f . u is missed by a
 * square of what the field is missed by.
 *
 * K + p S is positive definite between two pressures at which it is. Where it is not at one of
 * those given, the last pressure at which it is is found, and the field that it buckles in is among
 * what is spanned; so a negative eigenvalue there is one of the wall.
 */
class WallFields {
public:
  /// @param stiffness S, null: none, and no pressures
  WallFields(const ContinuumBody<3> &body, std::vector<ContinuumVector> forces,
             const PressureStiffness *const stiffness, std::vector<double> pressures);

  /// What all fields are made of.
  const std::vector<ContinuumVector> &basis() const { return spanning; }
  /// Parts of these in the field of each force (columns).
  Eigen::MatrixXd coefficients(const double pressure) const;
  /// Whether K + p S is known to be positive definite.
  bool is_stable(const double pressure) const {
    return least_stable - rounding_of_pressure() <= pressure &&
           pressure <= largest_stable + rounding_of_pressure();
  }
  /// Negative eigenvalues of K + p S on what is spanned.
  unsigned int n_negative(const double pressure) const;

private:
  /// Sums of loads in another order are the same pressure.
  double rounding_of_pressure() const {
    constexpr double part = 1e-10;
    return part * std::max(-least_stable, largest_stable);
  }
  /// Take the fields at the system's pressure into what is spanned, as differences from those
  /// before.
  void add_fields(ContinuumSystem &system, const double pressure);
  /// Go to a pressure from one at which the wall is stable, which becomes that pressure.
  /// @return whether the wall is stable there; else it stops before it buckles
  bool go_to(ContinuumSystem &system, const double pressure, double &stable);
  void stop_at_buckling(ContinuumSystem &system, double &stable, double beyond);
  void reduce(const PressureStiffness &stiffness);
  /// V^T S V of what is spanned.
  Eigen::MatrixXd reduced_stiffening(const PressureStiffness &stiffness,
                                     const Eigen::MatrixXd &V) const;
  /// V^T K V by what the fields solve. @param S, work V^T S V, V^T f
  Eigen::MatrixXd reduced_stiffness(const Eigen::MatrixXd &S, const Eigen::MatrixXd &work) const;

  /// A field that belongs to a force of its own: that of buckling.
  struct Mode {
    ContinuumVector field, force;
    double pressure;
  };

  const ContinuumBody<3> &body;
  const std::vector<ContinuumVector> forces;
  std::vector<ContinuumVector> spanning; ///< fields, their differences, modes
  std::vector<ContinuumVector> last;     ///< fields, while there are more to come
  std::vector<double> solved;            ///< pressures
  std::vector<Mode> modes;
  double least_stable = 0., largest_stable = 0.;
  Eigen::MatrixXd phi;    ///< of what is spanned; columns
  Eigen::MatrixXd on_phi; ///< phi . f of each force (columns)
  Eigen::VectorXd theta;
};

} // namespace frictionbeam
