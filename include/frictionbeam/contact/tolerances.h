// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam::contact {

/// Part of the largest force up to which rounding may excuse forces left unbalanced.
constexpr double most_excused = 1e-8;
/// Part of the predicted decrease with which a line search is content (Armijo's rule).
constexpr double sufficient_decrease = 1e-4;

} // namespace frictionbeam::contact
