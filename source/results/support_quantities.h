// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/results/results.h>

namespace frictionbeam {

/// What a quantity asks of one support: fn, ft1, ft2, gap, slip1, slip2, work, wear, impulse.
double support_value(const SupportState &support, const std::string &what);

/// sum_normal, sum_friction, n_stick, n_slip, n_open
double sum_over_supports(const std::vector<SupportState> &supports, const std::string &what);

/// From the lowest x on, the length over which supports slip [m]: to midway between the last one
/// that does and the next.
double slip_length(const std::vector<SupportInfo> &infos, const std::vector<SupportState> &states);

} // namespace frictionbeam
