// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/increment/resolution.h"

#include <algorithm>

namespace frictionbeam {

void Resolution::include(const Resolution &other) {
  local_errors += other.local_errors;
  largest_displacement = std::max(largest_displacement, other.largest_displacement);
  accelerations += other.accelerations;
  acceleration_changes += other.acceleration_changes;
  state_changes += other.state_changes;
  exact_in_time = exact_in_time && other.exact_in_time;
  handed_over = handed_over || other.handed_over;
  unbent = std::max(unbent, other.unbent);
  turned_in_motion += other.turned_in_motion;
  slip_turned = std::max(slip_turned, other.slip_turned);
  slip_from_rest = std::max(slip_from_rest, other.slip_from_rest);
  slip_is_known = slip_is_known && other.slip_is_known;
  touched_within = touched_within || other.touched_within;
  turned_unseen = turned_unseen || other.turned_unseen;
  loads_bend_within = loads_bend_within || other.loads_bend_within;
  forces_lag = forces_lag || other.forces_lag;
  starts_to_move = starts_to_move || other.starts_to_move;
  turned_within = turned_within || other.turned_within;
  slip_in_one = std::max(slip_in_one, other.slip_in_one);
  flow_increments += other.flow_increments;
  limit_changed_within = limit_changed_within || other.limit_changed_within;
}

} // namespace frictionbeam
