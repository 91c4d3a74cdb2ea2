// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/line/pieces.h"

namespace frictionbeam::import {

/**
 * Whether all pieces hang together. Free ends are listed in @p notes.
 * @throws UserError where a pipeline falls apart, or two free ends all but meet, with their places
 *   and distances
 */
void check_connections(const PcfFile &file, const PcfLine &line, const Network &network,
                       const double tolerance, Notes &notes);

} // namespace frictionbeam::import
