// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace frictionbeam {

/// What any number of a model lies within by its size: far wider than what is built, and far
/// narrower than what numbers can hold, so that products of several of them are still numbers.
struct PhysicalBounds {
  double smallest; ///< of a number that must be greater than zero, in SI units
  double largest;
};

/// Of a number with the unit @p si_unit, such as "N/m".
PhysicalBounds physical_bounds(const std::string &si_unit);

} // namespace frictionbeam
