// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/physical_bounds.h"

#include <map>

namespace frictionbeam {

PhysicalBounds physical_bounds(const std::string &si_unit) {
  static const std::map<std::string, PhysicalBounds> bounds = {
      {"m", {1e-12, 1e7}},     // atoms; a quarter of the Earth's circumference
      {"m2", {1e-24, 1e8}},    // of a section
      {"m4", {1e-36, 1e12}},   // of a section
      {"s", {1e-15, 1e10}},    // light in a micrometre; 300 years
      {"degC", {1e-12, 1e5}},  // the surface of stars
      {"K", {1e-12, 1e5}},     //
      {"Pa", {1e-12, 1e18}},   // a million times diamond, for what shall be rigid
      {"kg", {1e-12, 1e12}},   //
      {"kg/m", {1e-12, 1e10}}, //
      {"kg/m3", {1e-12, 1e9}}, // white dwarfs
      {"m/s", {1e-15, 3e8}},   // light
      {"m/s2", {1e-15, 1e10}}, //
      {"N", {1e-15, 1e18}},    // elastic stiffness EA too
      {"N/m", {1e-15, 1e20}},
      {"1/(Pa^n s)", {1e-300, 1e20}}, // of creep, whatever the exponent
      {"1/(Pa^k s^m)", {1e-300, 1e20}}};
  const auto found = bounds.find(si_unit);
  return found == bounds.end() ? PhysicalBounds{1e-20, 1e20} : found->second;
}

} // namespace frictionbeam
