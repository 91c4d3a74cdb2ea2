// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// The scene's spectra as a chart of the report, with the frequencies of the modes on them; empty
/// if there is none.
std::string spectrum_chart(const Scene &scene, const Results &results);

} // namespace frictionbeam
