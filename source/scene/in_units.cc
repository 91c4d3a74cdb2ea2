// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/in_units.h"

#include <sstream>

namespace frictionbeam {

std::string in_units(const UnitSystem &units, const double value, const std::string &si_unit) {
  std::ostringstream text;
  text << value / units.factor(si_unit) << ' ' << units.name(si_unit);
  return text.str();
}

std::string in_units(const UnitSystem &units, const dealii::Point<3> &position) {
  const double unit = units.factor("m");
  std::ostringstream text;
  text << '(' << position[0] / unit << ", " << position[1] / unit << ", " << position[2] / unit
       << ')';
  return text.str();
}

} // namespace frictionbeam
