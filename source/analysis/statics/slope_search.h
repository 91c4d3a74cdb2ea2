// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

namespace frictionbeam {

/**
 * How far to go along a step of Newton's method on a line that yields. Its potential, less the work
 * of the contacts' forces, which are held, is convex in small displacements. Its slope rises from
 * the start on; where the whole step is beyond the least, part of it is taken, until no more than
 * half of the slope is left.
 * @param slope at the start, < 0
 * @param slope_at of a part of the step, which it goes to; the last one asked is where it stays
 * @return that part
 */
double search_slope(const double slope, const std::function<double(double)> &slope_at);

} // namespace frictionbeam
