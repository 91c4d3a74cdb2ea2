// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam {

/// How transient steps are reduced to contact nodes and modes. Plain data.
struct ReductionSettings {
  enum class Modes { all, automatic, number } modes = Modes::all; ///< all: nothing is reduced
  unsigned int n_modes = 0;                                       ///< if a number is given
  double tolerance = 1e-3; ///< automatic: of contact forces and monitored motions, relative
};

} // namespace frictionbeam
