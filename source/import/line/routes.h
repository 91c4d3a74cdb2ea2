// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/line/pieces.h"

namespace frictionbeam::import {

/// Names that routes gave to the places of a network.
struct RouteNames {
  std::vector<std::string> nodes;           ///< by node; empty: in no route
  std::map<std::size_t, std::string> bends; ///< of the middle of bends, by piece
};

/**
 * Join pieces to pipes: one of each section, material, temperature and pressure from branch to
 * branch, rigid parts that follow each other as one with the sum of their masses. Points of a
 * straight run that nothing stands at are left out where the route passes them within @p tolerance.
 * Fills pipes and tees of @p plan.
 */
RouteNames make_routes(const PcfLine &line, const Network &network, const double tolerance,
                       LinePlan &plan, Notes &notes);

} // namespace frictionbeam::import
