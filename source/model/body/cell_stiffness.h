// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

namespace frictionbeam {

/// Stiffness of a cell that @p values stand on (gradients, JxW), of an isotropic elastic material.
template <int dim>
dealii::FullMatrix<double> cell_stiffness(const dealii::FEValues<dim> &values,
                                          const dealii::FESystem<dim> &fe, const double lambda,
                                          const double mu, const double thickness);

} // namespace frictionbeam
