// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/route_plan.h"

namespace frictionbeam {

/// Routes that gmsh has drawn, a curve for each piece of the plan, and meshed by transfinite
/// curves.
class DrawnRoutes {
public:
  /// @param name of the model
  DrawnRoutes(const std::string &name, const RoutePlan &plan);

  /// The vertices inside a piece of a pipe, without its ends, in the pipe's direction.
  const std::vector<Point3> &inside(const unsigned int pipe, const unsigned int piece) const {
    return inner[pipe][piece];
  }

private:
  std::vector<std::vector<std::vector<Point3>>> inner;
};

} // namespace frictionbeam
