// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * A round factor for displacements in pictures; 1 if there is none. The largest displacement of
 * @p frames is drawn as at most 8 % of the line's size, and, as long as the factor stays above 1,
 * no two places of the line come closer by it than 30 % of their distance: s |u_a - u_b| <= 0.7
 * |x_a - x_b|. So pipes beside each other do not cross, and none folds over itself.
 */
double displacement_scale(const std::vector<const Frame *> &frames);

} // namespace frictionbeam
