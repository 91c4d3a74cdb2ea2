// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/body/body.h"

namespace frictionbeam {

/// A base of the small rigid motions that the constraints of a body leave it, on all dofs of a
/// process and its neighbours'. The largest displacement of each is of the order of one.
template <int dim>
std::vector<ContinuumVector> rigid_motions(const ContinuumBody<dim> &body);

} // namespace frictionbeam
