// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <string>
#include <vector>

namespace frictionbeam::accuracy {

/// Why the wall of a line moves otherwise than its beams, in sentences: flexibilities of its bends,
/// what gives way under supports and what the wall widens by; by the figures of doc/solid.md, from
/// which `Model = auto` judges. @param line answer of the beams
std::vector<std::string> why_walls_differ(const Scene &scene, const Results &line);

} // namespace frictionbeam::accuracy
