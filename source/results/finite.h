// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// The last gate: what of the results is not a finite number, in plain words; empty if all are.
std::string first_not_finite(const Results &results);

/// Results with a number that is not finite have failed, whatever the solver says, and say why.
void refuse_not_finite(Results &results);

} // namespace frictionbeam
