// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/pipe_path.h"

namespace frictionbeam {

/// Where a named point is on a pipe, along it [m], within @p tolerance [m]; empty: nowhere.
std::vector<double> places_of(const Scene &scene, const PipePath &path, const std::string &point,
                              const double tolerance);

/// The same of all anchors that stand at points.
std::vector<double> places_of_anchors(const Scene &scene, const PipePath &path,
                                      const double tolerance);

} // namespace frictionbeam
