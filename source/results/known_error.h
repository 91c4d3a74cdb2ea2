// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>

namespace frictionbeam {

/// Relative error that one choice of the user's leaves in the displacements, as far as one run can
/// know it.
struct KnownError {
  std::optional<double> error; ///< none: not estimated
  std::string reason;          ///< where the number is from, or why there is none
  bool is_of_walls = false;    ///< of solid parts that the file names, which no Accuracy refines
};

/// How well the answer of a run is known, besides that its equations are solved: what load
/// increments, time steps and cells leave.
struct HowWellKnown {
  KnownError increments, time_step, cells;
};

} // namespace frictionbeam
