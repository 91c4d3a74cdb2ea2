// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/**
 * What a quantity asks of several supports (QuantityKind::Of::supports). slip_length is the
 * length over which supports slip [m], to a spacing of theirs, along the line from the lowest x, or
 * of the coordinate in which they extend furthest, to the highest; on rigid supports of one bound,
 * where the friction of a bed would be used up.
 */
double value_of_supports(const std::vector<SupportInfo> &infos,
                         const std::vector<SupportState> &states, const QuantityKind &kind);

} // namespace frictionbeam
