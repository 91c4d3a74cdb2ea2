// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/line/network.h"
#include "import/line/section_plan.h"
#include "import/pcf/pcf_component.h"

namespace frictionbeam::import {

/**
 * Make pieces of components.
 * @param tolerance within which ends are the same [m]
 * @throws UserError for components of no length, elbows whose centre does not fit, pipes that lie
 *   on each other
 */
Network make_pieces(const PcfFile &file, const PcfLine &line, const double tolerance,
                    SectionPlanner &sections, Notes &notes);

} // namespace frictionbeam::import
