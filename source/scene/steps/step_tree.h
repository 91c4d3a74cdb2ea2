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

/// Whether a case has one state of the line in it, and what adds to it: a step, or a sum (srss,
/// absolute, by the factors' sizes) whose factors of steps, and of cases that are such, add up to
/// about 1.
bool is_state(const Scene &scene, const std::string &name);
/// Whether what a state may be at most (capacities, allowable loads) says something of a case: of a
/// state, and of what the spectra do alone; not of a difference, of two states together, and of
/// envelopes, whose cases are judged themselves.
bool is_judged(const Scene &scene, const std::string &name);

} // namespace frictionbeam
