// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"
#include "results/results.h"

namespace frictionbeam {

/// Say what of an answer is hardly meant (Results::doubts): displacements for which small ones are
/// wrong, supports that all stand open, sagging spans, stresses above yield, time steps that miss a
/// mode.
void add_doubts(const Model &model, Results &results);

} // namespace frictionbeam
