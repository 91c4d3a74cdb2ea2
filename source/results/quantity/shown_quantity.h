// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// SI unit of what a quantity measures, over an interval of time if it does.
std::string unit_of(const Quantity &quantity);

/// A quantity's value, in SI units, as it is shown: in its unit, with its reference and error.
QuantityResult shown(const Scene &scene, const Quantity &quantity, const double value);

} // namespace frictionbeam
