// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_values.h>

namespace frictionbeam {

/**
 * Local axes of a straight cell, unit vectors in global axes: x along the cell, z as near to global
 * z as can be (global x for a vertical cell), y = z x x.
 */
struct LocalAxes {
  dealii::Tensor<1, 3> x, y, z;

  /// @param direction of the cell, of any length but zero.
  explicit LocalAxes(const dealii::Tensor<1, 3> &direction);
};

/**
 * Generalized strains of a line in its local axes: axial strain, two shears, twist [rad/m], two
 * curvatures [rad/m], in this order:
 *   eps = x.u',  gamma_y = y.u' - theta_z,  gamma_z = z.u' + theta_y,
 *   chi = x.theta',  kappa_y = y.theta',  kappa_z = z.theta'.
 */
using GeneralizedStrain = dealii::Tensor<1, 6>;
/// What does work on them, in the same order: N, V_y, V_z [N], M_x, M_y, M_z [N m].
using GeneralizedStress = dealii::Tensor<1, 6>;

/**
 * Generalized strain of the motion of a straight line's section.
 * @param rotation theta, @param du, dtheta derivatives along the line
 */
GeneralizedStrain generalized_strain(const LocalAxes &axes, const dealii::Tensor<1, 3> &rotation,
                                     const dealii::Tensor<1, 3> &du,
                                     const dealii::Tensor<1, 3> &dtheta);

/**
 * Generalized strain of shape function @p i at quadrature point @p q. Right for the non-primitive
 * functions of FE_Line in 1D-in-3D, where FEValues views of deal.II 9.4 are not. Needs
 * update_values and update_gradients.
 * @param first_component of the line's six: not 0 in an FESystem that begins with another element,
 * see line_part()
 */
GeneralizedStrain generalized_strain(const dealii::FEValuesBase<1, 3> &fe_values,
                                     const LocalAxes &axes, const unsigned int i,
                                     const unsigned int q, const unsigned int first_component = 0);

/// Generalized strain at quadrature point @p q of the cell's solution with the values @p
/// dof_values.
GeneralizedStrain generalized_strain(const dealii::FEValuesBase<1, 3> &fe_values,
                                     const LocalAxes &axes, const std::vector<double> &dof_values,
                                     const unsigned int q);

} // namespace frictionbeam
