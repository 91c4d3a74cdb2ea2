// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/generalized_strain.h>

namespace frictionbeam {

using namespace dealii;

LocalAxes::LocalAxes(const Tensor<1, 3> &direction) : x(direction / direction.norm()) {
  // Steeper than one in a million counts as vertical: there, z would follow rounding errors.
  const bool vertical = std::hypot(x[0], x[1]) < 1e-6;
  Tensor<1, 3> up;
  up[vertical ? 0 : 2] = 1.;
  z = up - (up * x) * x;
  z /= z.norm();
  y = cross_product_3d(z, x);
}

GeneralizedStrain generalized_strain(const LocalAxes &axes, const Tensor<1, 3> &rotation,
                                     const Tensor<1, 3> &du, const Tensor<1, 3> &dtheta) {
  GeneralizedStrain strain;
  strain[0] = axes.x * du;
  strain[1] = axes.y * du - axes.z * rotation;
  strain[2] = axes.z * du + axes.y * rotation;
  strain[3] = axes.x * dtheta;
  strain[4] = axes.y * dtheta;
  strain[5] = axes.z * dtheta;
  return strain;
}

GeneralizedStrain generalized_strain(const FEValuesBase<1, 3> &fe_values, const LocalAxes &axes,
                                     const unsigned int i, const unsigned int q,
                                     const unsigned int first_component) {
  const unsigned int first = first_component;
  Tensor<1, 3> rotation, du, dtheta;
  for (unsigned int c = 0; c < 3; ++c) {
    rotation[c] = fe_values.shape_value_component(i, q, first + 3 + c);
    du[c] = fe_values.shape_grad_component(i, q, first + c) * axes.x;
    dtheta[c] = fe_values.shape_grad_component(i, q, first + 3 + c) * axes.x;
  }
  return generalized_strain(axes, rotation, du, dtheta);
}

GeneralizedStrain generalized_strain(const FEValuesBase<1, 3> &fe_values, const LocalAxes &axes,
                                     const std::vector<double> &dof_values, const unsigned int q) {
  AssertDimension(dof_values.size(), fe_values.dofs_per_cell);
  GeneralizedStrain strain;
  for (unsigned int i = 0; i < dof_values.size(); ++i)
    strain += dof_values[i] * generalized_strain(fe_values, axes, i, q);
  return strain;
}

} // namespace frictionbeam
