// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/turnable/model_stations.h"

#include <nlohmann/json.hpp>

namespace frictionbeam {

/**
 * The least and the largest of each transient step with their instants, each by its name: of the
 * six section forces at the stations [N, N m] where MotionBudget has room for them, and of supports
 * (ft: the friction force's size) and restraints as rows least, at, largest, at, in the units of
 * the csv files; null where there is none.
 * @param supports places in Results::supports
 */
nlohmann::ordered_json model_envelopes(const Scene &scene, const Results &results,
                                       const ModelStations &stations,
                                       const std::vector<std::size_t> &supports,
                                       const std::size_t n_restraints);

} // namespace frictionbeam
