// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/unknowns/discretization.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

/// Largest coordinate of the line at rest [m], in whose last bits lengths of chords are known.
inline double largest_coordinate(const Discretization &discretization) {
  double largest = 0.;
  for (unsigned int v = 0; v < discretization.n_line_vertices(); ++v)
    for (unsigned int d = 0; d < 3; ++d)
      largest = std::max(largest, std::abs(discretization.vertices()[v][d]));
  return largest;
}

/// Largest component of a displacement of the line's vertices, among all degrees of freedom [m].
inline double largest_displacement(const Discretization &discretization, const Vector &dofs) {
  double largest = 0.;
  for (unsigned int v = 0; v < discretization.n_line_vertices(); ++v)
    for (unsigned int d = 0; d < 3; ++d)
      largest = std::max(largest, std::abs(dofs[discretization.vertex_dofs().index(v, d)]));
  return largest;
}

/// Longest edge of the box along the axes that holds the line at rest [m].
inline double line_extent(const Discretization &discretization) {
  double longest = 0.;
  for (unsigned int d = 0; d < 3; ++d) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (unsigned int v = 0; v < discretization.n_line_vertices(); ++v) {
      low = std::min(low, discretization.vertices()[v][d]);
      high = std::max(high, discretization.vertices()[v][d]);
    }
    longest = std::max(longest, high - low);
  }
  return longest;
}

} // namespace frictionbeam
