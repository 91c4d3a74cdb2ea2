// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/body.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>

namespace frictionbeam {

/// Constrain the nodes of a cross-section, on elements that are systems of one scalar element.
void hold_section(const dealii::MappingQ<3> &mapping, const dealii::DoFHandler<3> &dof_handler,
                  const HeldSection &section, dealii::AffineConstraints<double> &constraints);

} // namespace frictionbeam
