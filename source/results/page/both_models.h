// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <map>

namespace frictionbeam {

/// Take over what one model of a scene gave, with its name before every name: `line/u_0`.
void include_model(Results &both, const Results &results, const std::string &model);

/// The quantities of the models side by side, as HTML.
/// @param other the word of the model beside the line
/// @param rounding by unit: what is smaller is rounding, and shown as zero
std::string side_by_side(const Results &both, const std::string &other,
                         const std::map<std::string, double> &rounding);

} // namespace frictionbeam
