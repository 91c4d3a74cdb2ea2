// SPDX-License-Identifier: LGPL-2.1-or-later
// Where events do not get on, small steps do.
#include "analysis/event/event_integrator.h"

#include <algorithm>

namespace frictionbeam {

namespace {

constexpr unsigned int steps_handed_over = 40;
constexpr double part_handed_over = 0.01; ///< of a step
/// So often slip may go straight on where its curve is not found.
constexpr unsigned int most_unresolved = 20;

} // namespace

bool EventIntegrator::is_stuck(const Event &event) {
  const bool unresolved = n_unresolved > most_unresolved;
  if (!unresolved && (event.x > 1. || ++n_at_once <= 20 + 10 * states.size()))
    return false;
  reason = unresolved ? "slip along a curve is not resolved" : "states change without end";
  n_unresolved = n_at_once = 0;
  return true;
}

TimeStep EventIntegrator::hand_over_after(const TimeStep &step, const LoadCourse &loads,
                                          const double time, LineState &to) {
  set_imposed(0., motion_length);
  write(loads, to);
  const LineState middle = to;
  TimeStep rest =
      hand_over(middle, loads, std::min(time, present + part_handed_over * output_step), to);
  rest.handed_over = true;
  rest.energy += step.energy;
  rest.result.iterations += step.result.iterations;
  return rest;
}

TimeStep EventIntegrator::hand_over(const LineState &from, const LoadCourse &loads,
                                    const double time, LineState &to) {
  if (n_handed_over == 0)
    first_handed_over = from.time;
  ++n_handed_over;
  time_handed_over += time - from.time;
  TimeStep all;
  LineState now = from;
  fallback.start(now, loads);
  for (unsigned int k = 1; k <= steps_handed_over; ++k) {
    const double goal =
        k == steps_handed_over ? time : from.time + (time - from.time) * k / steps_handed_over;
    if (goal <= now.time)
      continue;
    const std::vector<ContactEvent> events = now.events;
    TimeStep step = fallback.advance(now, loads, goal, to);
    all.result = step.result;
    if (!step.result.converged)
      return all;
    to.events.insert(to.events.begin(), events.begin(), events.end());
    all.energy += step.energy;
    now = to;
  }
  read_states(to, loads);
  ground_may_jump = true;
  at_rest_on_ground = loads.next_break(from.time) > time;
  return all;
}

} // namespace frictionbeam
