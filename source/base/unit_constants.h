// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// @file Units that are exact by definition (NIST SP 811, appendix B.8), in SI units.
namespace frictionbeam {

inline constexpr double standard_gravity = 9.80665; ///< [m/s2], CGPM 1901
inline constexpr double inch = 0.0254;              ///< [m]
inline constexpr double pound = 0.45359237;         ///< avoirdupois [kg]

} // namespace frictionbeam
