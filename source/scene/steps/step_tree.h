// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

/// The step from whose end a step starts: that of its entry From, or the one before it; none for
/// the first, which starts from the line as it is built.
std::optional<unsigned int> step_before(const Scene &scene, const unsigned int step);

/// Whether a step starts elsewhere than at the end of the step before it in the file.
bool is_branch(const Scene &scene, const unsigned int step);

/// Whether a later step goes back to the end of this one.
bool is_returned_to(const Scene &scene, const unsigned int step);

/// Whether a case is a difference of states: a range, or a sum whose factors of steps, and of cases
/// that are such, add up to nothing.
bool is_difference(const Scene &scene, const std::string &name);
/// Whether it is a state, or as many.
bool is_state(const Scene &scene, const std::string &name);

} // namespace frictionbeam
