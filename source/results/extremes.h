// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <limits>

namespace frictionbeam {

/// Least and largest value of a number over a transient step, each with the first instant at which
/// it was met [s].
struct Extremes {
  double least = std::numeric_limits<double>::infinity(),
         largest = -std::numeric_limits<double>::infinity();
  double least_at = 0., largest_at = 0.;

  /// @return whether the value is a new extreme.
  bool include(const double value, const double time) {
    const bool below = value<least, above = value> largest;
    if (below) {
      least = value;
      least_at = time;
    }
    if (above) {
      largest = value;
      largest_at = time;
    }
    return below || above;
  }
  bool is_known() const { return least <= largest; }
  /// The one of larger size, with its sign; 0 if nothing is known.
  double extreme() const { return !is_known() ? 0. : least_is_larger() ? least : largest; }
  double extreme_at() const { return least_is_larger() ? least_at : largest_at; }

private:
  bool least_is_larger() const { return std::abs(least) > std::abs(largest); }
};

} // namespace frictionbeam
