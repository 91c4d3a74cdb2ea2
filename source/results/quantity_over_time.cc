// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/results/collector.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// Straight line between two instants.
double between(const double t0, const double x0, const double t1, const double x1, const double t) {
  return t1 > t0 ? x0 + (t - t0) / (t1 - t0) * (x1 - x0) : x1;
}

} // namespace

void Collector::find_change(const Quantity &quantity, const LineState &state,
                            Pending &change) const {
  const ContactStatus wanted = quantity.what == "stick"  ? ContactStatus::stick
                               : quantity.what == "slip" ? ContactStatus::slip
                               : quantity.what == "open" ? ContactStatus::open
                                                         : ContactStatus::closed;
  for (const ContactEvent &event : state.events) {
    // closed: with or without friction
    const bool is_it = event.status == wanted ||
                       (wanted == ContactStatus::closed && event.status != ContactStatus::open);
    if (!change.value && is_it && event.time >= quantity.from &&
        results.supports[event.contact].name == quantity.where)
      change.value = quantity.scale * event.time;
  }
}

void Collector::follow(const Quantity &quantity, const LineState &state, Pending &course) {
  using Over = Quantity::Over;
  if (course.since > quantity.to)
    return;
  const double rounding = 1e-9 * std::abs(state.time), value = evaluate(quantity, state);
  const double before = course.previous, since = course.since;
  course.previous = value;
  course.since = state.time;
  if (state.time < quantity.from - rounding || since > quantity.to)
    return;
  // Both ends of the interval may lie between two instants.
  const double first = course.begun ? since : std::max(since, std::min(quantity.from, state.time)),
               last = std::min(state.time, quantity.to);
  const double at_first = between(since, before, state.time, value, first),
               at_last = between(since, before, state.time, value, last);
  if (quantity.over == Over::maximum || quantity.over == Over::minimum) {
    const double sign = quantity.over == Over::maximum ? 1. : -1.;
    double extreme = sign * at_last;
    if (course.begun)
      extreme = std::max(extreme, sign * *course.value);
    else if (quantity.from > since)
      extreme = std::max(extreme, sign * at_first);
    course.value = sign * extreme;
  } else {
    course.largest = std::max({course.largest, std::abs(at_first), std::abs(at_last)});
    course.sum += (last - first) * (at_first + at_last) / 2.;
    course.duration += last - first;
    if (!course.begun)
      course.at_start = at_first;
    const double change = at_last - course.at_start;
    const bool lasts = course.duration > 0.;
    course.value = quantity.over == Over::integral ? course.sum
                   : quantity.over == Over::change ? change
                   : quantity.over == Over::rate   ? (lasts ? change / course.duration : 0.)
                   : lasts                         ? course.sum / course.duration
                                                   : value;
  }
  course.begun = true;
}

} // namespace frictionbeam
