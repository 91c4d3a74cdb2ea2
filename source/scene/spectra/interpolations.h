// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/choice.h"
#include "scene/modal.h"

namespace frictionbeam {

/// The words for what is straight between two points of a spectrum, of the entry and of `record`.
inline constexpr Word<Spectrum::Interpolation> spectrum_interpolations[] = {
    {"log-log", Spectrum::Interpolation::logarithmic,
     "straight on logarithmic axes; linear where one of the numbers is 0"},
    {"linear", Spectrum::Interpolation::in_frequency, "in the frequency"},
    {"linear in period", Spectrum::Interpolation::in_period}};

} // namespace frictionbeam
