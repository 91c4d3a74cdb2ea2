// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/pcf/pcf_component.h"

namespace frictionbeam::import {

/// Give components that say nothing of temperature, pressure, contents and metal, as gaskets do,
/// those of what they are joined to within @p tolerance [m]; it is said in @p notes.
void complete_by_neighbours(PcfLine &line, const double tolerance, Notes &notes);

} // namespace frictionbeam::import
