// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"
#include "results/results.h"

namespace frictionbeam {

/// The station of a quantity's point on the asked side; null if no pipe, or none of the asked name,
/// has it. A pipe that ends at the point has nothing after it; another one may.
const Station *find_station(const Model &model, const Quantity &quantity, const Frame &made);

/// The same. @throws UserError if there is none
const Station &station_at(const Model &model, const Quantity &quantity, const Frame &made);

} // namespace frictionbeam
