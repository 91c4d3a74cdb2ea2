// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// The modes as a table with the first shapes as pictures, as HTML; empty if there are none.
std::string mode_section(const Scene &scene, const Results &results);

/// Write `modes.csv` into @p folder: mode, frequency, period, participation and part of the mass in
/// each direction, residual. Nothing if there are no modes.
void write_modes(const Results &results, const std::string &folder);

} // namespace frictionbeam
