// SPDX-License-Identifier: LGPL-2.1-or-later
// Headers that most files of the application need and that take long to read.
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
