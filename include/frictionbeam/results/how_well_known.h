// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>

namespace frictionbeam {

struct Results;
struct Scene;

/// Relative error that one choice of the user's leaves in the displacements, as far as one run can
/// know it.
struct KnownError {
  std::optional<double> error; ///< none: not estimated
  std::string reason;          ///< where the number is from, or why there is none
};

/// How well the answer of a run is known, besides that its equations are solved: what load
/// increments, time steps and cells leave.
struct HowWellKnown {
  KnownError increments, time_step, cells;
};

/// Of a run of the line, from what its increments left behind.
HowWellKnown how_well_known(const Scene &scene, const Results &results);

/// An Accuracy that was demanded has measured what one run cannot.
void include_accuracy(Results &results);

/// "12 %", "0.03 %", "exact", "not estimated".
std::string in_words(const KnownError &known);

/// Remarks on what is known to no better than 5 %.
void add_remarks(const HowWellKnown &known, Results &results);

} // namespace frictionbeam
