// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/frame/frame_builder.h"
#include "results/results.h"

namespace frictionbeam {

/// Component 0 to 2 of the force [N], 3 to 5 of the moment [N m], global axes, of friction support
/// @p i on its pipe.
double force_of_support(const FrameBuilder &builder, const Results &results, const unsigned int i,
                        const LineState &state, const unsigned int component);

/// The same of all that holds a point: restraints, springs, hangers, friction supports. The builder
/// has made the frame of this state.
double force_at_point(const Model &model, const FrameBuilder &builder, const Results &results,
                      const std::string &point, const LineState &state,
                      const unsigned int component);

} // namespace frictionbeam
