// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/frame/frame_builder.h"
#include "results/results.h"

#include <optional>

namespace frictionbeam {

/// Whether @p where names a friction support, or the guide, line stop or stop of which it is a
/// half: `name` of `name.plus` and `name.minus`, `name.1` of `name.plus.1` and `name.minus.1`.
bool is_part_of(const SupportInfo &support, const std::string &where);
/// The same, or all places where it stands: `name` of `name.1` and `name.plus.1`.
bool is_one_of(SupportInfo support, const std::string &where);

/// Component 0 to 2 of the force [N], 3 to 5 of the moment [N m], global axes, of a friction
/// support on its pipe, by its name, of both halves of a pair; nothing if there is none.
std::optional<double> force_of_supports(const Model &model, const Results &results,
                                        const std::string &name, const LineState &state,
                                        const unsigned int component);

/// The same of all that holds a point: restraints, springs, hangers, friction supports. The builder
/// has made the frame of this state.
double force_at_point(const Model &model, const FrameBuilder &builder, const std::string &point,
                      const LineState &state, const unsigned int component);

/// Of a place that is none that forces act at.
/// @throws UserError
[[noreturn]] void refuse_place(const Quantity &quantity);

} // namespace frictionbeam
