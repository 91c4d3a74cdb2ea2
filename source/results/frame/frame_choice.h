// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// The frames that a report shows: the ends of the steps, or where there are more than @p n_most,
/// that many of them with the first and the last; the last frame of a run that did not come to the
/// end of a step.
std::vector<const Frame *> frames_to_show(const Results &results, const unsigned int n_most);

} // namespace frictionbeam
