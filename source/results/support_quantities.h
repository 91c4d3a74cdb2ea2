// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/results/results.h>

namespace frictionbeam {

/// What a quantity asks of one support: fn, ft1, ft2, gap, slip1, slip2, work, wear, impulse.
double support_value(const SupportState &support, const std::string &what);

/// sum_normal, sum_friction, n_stick, n_slip, n_open
double sum_over_supports(const std::vector<SupportState> &supports, const std::string &what);

/// From the lowest x on, the length over which supports slip [m], to a spacing of theirs. Each one
/// stands for the length to midway between it and its neighbours, the first that does not slip for
/// as much of it as its share of the friction per length of the last that does: on rigid supports
/// of one bound that is where the friction of a bed would be used up.
double slip_length(const std::vector<SupportInfo> &infos, const std::vector<SupportState> &states);

} // namespace frictionbeam
