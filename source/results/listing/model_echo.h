// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <string>

namespace frictionbeam {

/// The line as it was understood, as HTML: named nodes with their coordinates, and the elements
/// between them with section, material, length and temperatures, both folded; empty without pipes.
std::string model_echo(const Scene &scene, const Results &results);

} // namespace frictionbeam
