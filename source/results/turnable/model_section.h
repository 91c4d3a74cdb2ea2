// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * The model that one can turn, as HTML: a canvas with its controls, data and scripts, three.js
 * among them, all within the page. The library and the data are packed by gzip, which the browser
 * unpacks (`DecompressionStream`). Where the program was built without three.js, a line that says
 * so; a browser without WebGL says so in its place.
 */
std::string model_section(const Scene &scene, const Results &results,
                          const std::vector<const Frame *> &frames, const double scale);

} // namespace frictionbeam
