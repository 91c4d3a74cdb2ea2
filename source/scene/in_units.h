// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/units.h"

#include <deal.II/base/point.h>

#include <string>

namespace frictionbeam {

/// A value in SI as messages show it: six digits in the file's unit for @p si_unit, and that unit.
std::string in_units(const UnitSystem &units, const double value, const std::string &si_unit);

/// A place as messages show it: "(1000, 0, 609)", in the file's unit of length.
std::string in_units(const UnitSystem &units, const dealii::Point<3> &position);

} // namespace frictionbeam
