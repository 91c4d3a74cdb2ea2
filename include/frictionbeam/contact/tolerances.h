// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam::contact {

/// Part of the largest force up to which rounding may excuse forces left unbalanced.
constexpr double most_excused = 1e-8;
/// Forces below this part of the largest of a load sequence are judged as if they were as large: at
/// the usual tolerance of 1e-10 that is rounding.
constexpr double least_force = 1e-4;
/// Part of the predicted decrease with which a line search is content (Armijo's rule).
constexpr double sufficient_decrease = 1e-4;

} // namespace frictionbeam::contact
