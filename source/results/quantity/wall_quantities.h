// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/step_report.h"
#include "model/line_state.h"
#include "model/model.h"
#include "scene/quantity.h"

#include <optional>
#include <string>
#include <vector>

namespace frictionbeam {

/// A quantity of sections that yield or creep: of the nearest to its point, the largest of the line
/// without one.
double value_of_wall(const Model &model, const Quantity &quantity, const LineState &state);

/// Cells in which a section has yielded: pipe, and the way along it to their middle [m].
std::vector<std::pair<unsigned int, double>> yielded_cells(const Model &model,
                                                           const LineState &state);

/// What is known of a step by itself, its limit load or its cycle.
std::optional<double> value_of_step(const Quantity &quantity, const StepReport &step);

/// Why a quantity has no value at the end of a run, as the end of a sentence.
std::string why_no_value(const Quantity &quantity, const std::vector<StepReport> &steps);

} // namespace frictionbeam
