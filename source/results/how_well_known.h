// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// Of a run of the line, from what its increments left behind.
HowWellKnown how_well_known(const Scene &scene, const Results &results);

/// An Accuracy that was demanded has measured what one run cannot.
void include_accuracy(Results &results);

/// "12 %", "0.03 %", "exact", "not estimated".
std::string in_words(const KnownError &known);

/// Remarks on what is known to no better than 5 %.
void add_remarks(const HowWellKnown &known, Results &results);

} // namespace frictionbeam
