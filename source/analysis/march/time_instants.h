// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/load_course.h"

namespace frictionbeam {

/// Ends of the time steps of a transient step, ascending: between two instants at which a history
/// jumps or bends, equal steps no longer than @p longest, so that a jump is at the end of a step.
std::vector<double> instants_of_steps(const LoadCourse &course, const double start,
                                      const double end, const double longest);

/// Instants at which a transient step is observed whose integrator has no steps of its own: equally
/// far apart, and those of quantities.
std::vector<double> instants_of_output(const Model &model, const double start, const double end,
                                       const double longest);

} // namespace frictionbeam
