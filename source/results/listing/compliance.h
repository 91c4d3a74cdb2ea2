// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

#include <string>

namespace frictionbeam {

/// @file
/// What a stress code says of each node: case, factors, forces, stress, allowable, ratio.

/// As HTML, a tab for each case with the named nodes and the worst one, folded; empty if there are
/// no stresses.
std::string compliance_section(const Scene &scene, const Results &results);

/// Write compliance.csv, every node of every case, in the units of the results; none if there are
/// no stresses.
void write_compliance(const Scene &scene, const Results &results, const std::string &folder);

} // namespace frictionbeam
