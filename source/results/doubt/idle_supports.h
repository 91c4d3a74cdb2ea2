// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// A remark on friction supports at points that an anchor or a restraint holds along their normal:
/// in all steps they stay as they were installed and have no force, while the other has one there.
void remark_on_idle_supports(const Scene &scene, Results &results);

} // namespace frictionbeam
