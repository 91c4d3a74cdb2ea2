// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam::accuracy {

/// How far two answers are apart in one quantity.
struct Difference {
  double value = 0.; ///< relative
  std::string name;  ///< of the quantity
  double scale = 1.; ///< that it is relative to
  double least = 0.; ///< that increments may leave, whatever the difference
};

/**
 * Differences of the quantities that the scene names, each relative to its value in @p fine, or to
 * a hundredth of the largest with the same unit if that is more, of a change or a rate also to a
 * hundredth of what changes; and to no less than a millionth of the largest displacement or force
 * anywhere on the line, of an energy of their product, so that a value that is nothing but rounding
 * does not count. Where it asks for max_error, the motion of that point is compared at all instants
 * of @p coarse. Numbers of supports (n_stick, n_slip, n_open) do not count.
 */
std::vector<Difference> differences(const Scene &scene, const Results &coarse, const Results &fine);

/// The largest of them; none: zero.
Difference largest(const std::vector<Difference> &differences);

/// Names of the quantities that do not count, and why, for the user.
std::vector<std::string> left_out(const Scene &scene);

/// The same of what solid pipes have beside them.
std::string left_out_of_walls();

/// Quantities that only the model has that is not solved.
std::vector<std::string> left_out_by(const ModelKind model, const Scene &scene);

} // namespace frictionbeam::accuracy
