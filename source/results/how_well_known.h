// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// How far beyond its elastic bound a pipe is between the sections of a cell that is solved as
/// elastic, the furthest of all, of the bound; 0: none is by more than rounding.
double unseen_yield(const Results &results);

/// Of a run of the line, from what its increments left behind.
HowWellKnown how_well_known(const Scene &scene, const Results &results);

/// An Accuracy that was demanded has measured what one run cannot.
/// @param chooses_increments whether it does for this model
void include_accuracy(const bool chooses_increments, Results &results);

/// "12 %", "0.03 %", "exact", "not estimated".
std::string in_words(const KnownError &known);

/// Remarks on what is known to no better than 5 %, and on increments of which nothing is known.
void add_remarks(const HowWellKnown &known, const bool chooses_increments, Results &results);

} // namespace frictionbeam
