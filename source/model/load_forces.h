// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"

#include <vector>

namespace frictionbeam {

/// Forces on the unknowns of loads with these factors, and of platens, which are always there.
Vector load_forces(const Model &model, const std::vector<double> &factors);

} // namespace frictionbeam
