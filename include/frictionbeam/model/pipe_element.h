// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/generalized_strain.h>
#include <frictionbeam/model/discretization.h>

#include <Eigen/Core>

namespace frictionbeam {

/**
 * Matrices and vectors of one pipe cell, integrated through FEValues. Degrees of freedom stand in
 * the order of deal.II's cell: 6 at vertex 0, 6 at vertex 1, global axes.
 */
class PipeElement {
public:
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  using Vector12 = Eigen::Matrix<double, 12, 1>;

  explicit PipeElement(const Discretization &discretization);

  /// Evaluate the shape functions on a cell; the functions below then speak of it.
  void reinit(const Discretization::Cell &cell);

  /// Integral of B^T D B, exact with two Gauss points.
  Matrix12 stiffness() const;
  /// Forces of a unit force per length in each global direction (columns) [N per N/m].
  Eigen::Matrix<double, 12, 3> unit_line_loads() const;
  /// Nodal forces that a unit axial strain, if it were free, would need.
  Vector12 unit_axial_strain() const;
  /// Consistent mass with rotary inertia, exact with four Gauss points.
  Matrix12 mass(const Discretization::Cell &cell);

  const Profile &profile() const { return *section; }

private:
  const Discretization &discretization;
  dealii::FEValues<1, 3> values, mass_values;
  const Profile *section = nullptr;
  std::array<std::array<GeneralizedStrain, 12>, 2> strains; ///< by quadrature point, function
};

} // namespace frictionbeam
