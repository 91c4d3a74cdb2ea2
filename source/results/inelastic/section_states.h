// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"
#include "results/section_results.h"

namespace frictionbeam {

/// Sections of a pipe cell, in the order of the route; none if it neither yields nor creeps.
std::vector<SectionState> sections_of_cell(const Model &model, const unsigned int cell,
                                           const LineState &state);

/// Those of all cells, pipe by pipe.
std::vector<SectionState> sections_of_line(const Model &model, const LineState &state);

} // namespace frictionbeam
