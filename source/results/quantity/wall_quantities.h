// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"
#include "scene/quantity.h"

namespace frictionbeam {

/// A quantity of sections that yield or creep: of the nearest to its point, the largest of the line
/// without one.
double value_of_wall(const Model &model, const Quantity &quantity, const LineState &state);

} // namespace frictionbeam
