// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "program.h"
#include "solution.h"

namespace oracle {

/// The largest difference of each kind between the program and the oracle, relative to the scene's
/// largest displacement, rotation, force or moment.
struct Comparison {
  double worst = 0.;    ///< largest of all
  std::string what;     ///< in words: where, the program's number and the oracle's
  int numbers = 0;      ///< that were compared
  double rounding = 0.; ///< of K u in double precision, relative to the largest force
  bool unsure = false;  ///< the oracle's own contacts have not converged

  /// @param rounded what rounding may have moved the number
  void add(const std::string &name, double program, double right, double scale,
           double rounded = 0.);
};

/// @param ask_rounding whether motions may differ by what rounding moves at most, which takes an
/// inverse of the line's stiffness
Comparison compare(const Outcome &program, const Solution &oracle, bool ask_rounding = false);

/// The oracle's answers, as lines of text.
std::string describe(const Scene &scene, const Solution &solution);

} // namespace oracle
