// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/model/pipe_element.h>

#include <deal.II/base/quadrature_lib.h>

namespace frictionbeam {

using namespace dealii;

PipeElement::PipeElement(const Discretization &discretization)
    : discretization(discretization), values(discretization.elements()[0], QGauss<1>(2),
                                             update_values | update_gradients | update_JxW_values),
      mass_values(discretization.elements()[0], QGauss<1>(4), update_values | update_JxW_values) {}

void PipeElement::reinit(const Discretization::Cell &cell) {
  values.reinit(cell);
  section = &discretization.profiles()[cell->material_id()];
  const LocalAxes axes(cell->vertex(1) - cell->vertex(0));
  for (unsigned int q = 0; q < 2; ++q)
    for (unsigned int i = 0; i < 12; ++i)
      strains[q][i] = generalized_strain(values, axes, i, q);
}

PipeElement::Matrix12 PipeElement::stiffness() const {
  Matrix12 result = Matrix12::Zero();
  for (unsigned int q = 0; q < 2; ++q) {
    Eigen::Matrix<double, 6, 12> B;
    for (unsigned int i = 0; i < 12; ++i)
      for (unsigned int c = 0; c < 6; ++c)
        B(c, i) = strains[q][i][c];
    const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> D(&section->tangent(0, 0));
    result.noalias() += values.JxW(q) * (B.transpose() * (D * B).eval());
  }
  return result;
}

Eigen::Matrix<double, 12, 3> PipeElement::unit_line_loads() const {
  Eigen::Matrix<double, 12, 3> result = Eigen::Matrix<double, 12, 3>::Zero();
  for (unsigned int q = 0; q < 2; ++q)
    for (unsigned int i = 0; i < 12; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        result(i, d) += values.shape_value_component(i, q, d) * values.JxW(q);
  return result;
}

PipeElement::Vector12 PipeElement::unit_axial_strain() const {
  Vector12 result = Vector12::Zero();
  for (unsigned int q = 0; q < 2; ++q)
    for (unsigned int i = 0; i < 12; ++i)
      result[i] += strains[q][i][0] * section->EA * values.JxW(q);
  return result;
}

PipeElement::Matrix12 PipeElement::mass(const Discretization::Cell &cell) {
  mass_values.reinit(cell);
  const Profile &profile = discretization.profiles()[cell->material_id()];
  Vector3 tangent = cell->vertex(1) - cell->vertex(0);
  tangent /= tangent.norm();
  Matrix12 result = Matrix12::Zero();
  for (unsigned int q = 0; q < 4; ++q)
    for (unsigned int i = 0; i < 12; ++i) {
      // Momentum of function i: about the axis a pipe has twice the inertia of a diameter.
      Vector3 rotation;
      for (unsigned int d = 0; d < 3; ++d)
        rotation[d] = mass_values.shape_value_component(i, q, 3 + d);
      const Vector3 spin = profile.rotary_inertia * (rotation + (rotation * tangent) * tangent);
      for (unsigned int j = 0; j < 12; ++j) {
        double sum = 0.;
        for (unsigned int d = 0; d < 3; ++d)
          sum += profile.mass * mass_values.shape_value_component(i, q, d) *
                     mass_values.shape_value_component(j, q, d) +
                 spin[d] * mass_values.shape_value_component(j, q, 3 + d);
        result(i, j) += sum * mass_values.JxW(q);
      }
    }
  return result;
}

} // namespace frictionbeam
