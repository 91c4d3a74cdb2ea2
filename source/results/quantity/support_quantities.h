// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// What a quantity asks of one support: fn, ft1, ft2, gap, slip1, slip2, work, wear,
/// impulse, mt.
double support_value(const SupportState &support, const std::string &what);

/**
 * What a quantity asks of all supports: sum_normal, sum_friction [N], n_stick, n_slip, n_open, and
 * slip_length, from the lowest x on the length over which supports slip [m], to a spacing of
 * theirs; on rigid supports of one bound, where the friction of a bed would be used up.
 */
double value_of_supports(const std::vector<SupportInfo> &infos,
                         const std::vector<SupportState> &states, const std::string &what);

} // namespace frictionbeam
