// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// Of a frame's nodes and stations, the size of the displacement that is largest [m].
double largest_motion(const Frame &frame);

/// At most so many of them, evenly chosen, with the first and the last.
std::vector<const Frame *> few_of(const std::vector<const Frame *> &frames,
                                  const unsigned int n_most);

/// The frames that a report shows: the ends of the steps, or where there are more than @p n_most,
/// that many of them with the first and the last; the last frame of a run that did not come to the
/// end of a step.
std::vector<const Frame *> frames_to_show(const Results &results, const unsigned int n_most);
/// The same for the report's pages: those that the scene names, or as many as a page can hold.
std::vector<const Frame *> frames_of_report(const Scene &scene, const Results &results);

} // namespace frictionbeam
