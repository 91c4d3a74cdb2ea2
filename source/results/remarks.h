// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// What the user should know: the remarks on the input and those of the analysis, each once.
std::vector<std::string> all_remarks(const Scene &scene, const Results &results);

} // namespace frictionbeam
