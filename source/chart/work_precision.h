// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "chart/measurement.h"

namespace frictionbeam::chart {

/// Places of the measurements that no other one beats in both error and time, in the order of time;
/// an error that is less by a hundredth only is no gain.
std::vector<std::size_t> efficient_front(const std::vector<Measurement> &measurements);

/// Place of the cheapest measurement with an error of at most @p accuracy, of all curves or of one.
std::optional<std::size_t> cheapest(const std::vector<Measurement> &measurements,
                                    const double accuracy,
                                    const std::optional<std::size_t> curve = {});

/// Label and setting, such as "exact, Slab/Elements = 64".
std::string name_of(const ChartList &list, const Measurement &measurement);

/// The list's advice with its figures filled in. @throws UserError for braces that mean nothing.
std::string filled_advice(const ChartList &list, const std::vector<Measurement> &measurements);

/// A duration for a reader, in s, ms or min.
std::string readable_time(const double seconds);

} // namespace frictionbeam::chart
