// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// A remark where a pipe bends more between two stations of a straight cell than anywhere at
/// stations, which are all that stress codes and yield stresses are held against.
void remark_on_peaks_between_stations(const Scene &scene, Results &results);

} // namespace frictionbeam
