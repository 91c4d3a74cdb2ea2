// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/envelope/smooth_courses.h"

#include "analysis/increment/contact_watch.h"
#include "base/numbers.h"
#include "results/quantity/collector.h"
#include "results/quantity/impact_forces.h"
#include "results/support/support_names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {

/// Instants closer than this part of their time are one, where their step is not known.
constexpr double same_instant_of_time = same_instant_of_step;

/// Straight line between two instants.
double between(const double t0, const double x0, const double t1, const double x1, const double t) {
  return t1 > t0 ? x0 + (t - t0) / (t1 - t0) * (x1 - x0) : x1;
}

/// Whether a contact that sticks or slips does so for some time: where slip turns it sticks for
/// none.
bool lasts(const std::vector<ContactEvent> &events, const std::size_t k) {
  const auto is_friction = [](const ContactEvent &event) {
    return event.status == ContactStatus::stick || event.status == ContactStatus::slip;
  };
  return !is_friction(events[k]) ||
         std::none_of(events.begin() + k + 1, events.end(), [&](const ContactEvent &later) {
           return later.contact == events[k].contact && is_friction(later) &&
                  later.status != events[k].status &&
                  later.time - events[k].time <= same_instant_of_time * later.time;
         });
}

} // namespace

void Collector::find_change(const Quantity &quantity, const LineState &state,
                            const bool ends_static, Pending &change) const {
  // What a static step has become at its end belongs to it, and not to what begins there.
  if (ends_static && state.time <= quantity.from * (1. + same_instant_of_time))
    return;
  const auto wanted = static_cast<ContactStatus>(quantity.kind().component);
  std::vector<ContactStatus> status = contacts_before.status;
  for (std::size_t k = 0; k < state.events.size(); ++k) {
    const ContactEvent &event = state.events[k];
    const bool was_closed =
        event.contact < status.size() && status[event.contact] != ContactStatus::open;
    if (!status.empty())
      status[event.contact] = event.status;
    // closed: with or without friction
    const bool is_it = wanted == ContactStatus::closed
                           ? event.status != ContactStatus::open && !was_closed
                           : event.status == wanted;
    if (!change.value && is_it && lasts(state.events, k) && event.time >= quantity.from &&
        event.time <= quantity.to &&
        is_part_of(results.supports[results.support_of[event.contact]], quantity.where)) {
      change.value = quantity.scale * event.time;
      change.apart = event.time == state.time ? state.time - previous_time : 0.;
    }
  }
}

void Collector::Pending::reach(const double sign, const double reached, const double time) {
  constexpr double rounding = 1e-12; // of an extreme
  if (!value ||
      sign * (reached - value_at) > rounding * std::max(std::abs(reached), std::abs(value_at))) {
    at = time;
    value_at = reached;
  }
  if (!value || sign * (reached - *value) > 0.)
    value = reached;
}

void Collector::follow(const Quantity &quantity, const LineState &state, Pending &course) {
  using Over = Quantity::Over;
  if (course.since > quantity.to)
    return;
  const double rounding = same_instant_of_time * std::abs(state.time),
               value = evaluate(quantity, state);
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
    if (!course.begun && quantity.from > since)
      course.reach(sign, at_first, first);
    course.reach(sign, at_last, last);
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

void Collector::follow_back(const Quantity &quantity, const LineState &state, Pending &course) {
  const double rounding = same_instant_of_time * std::abs(state.time);
  if (quantity.to <= state.time + rounding)
    course.since = std::numeric_limits<double>::infinity(); // it has ended with the step before
  else {
    if (quantity.from >= state.time - rounding)
      course = {};
    course.since = state.time;
    follow(quantity, state, course);
  }
}

namespace {

/// What changes with time within a piece; max_error is gathered at the ends of steps.
bool is_followed(const Quantity &quantity) {
  return quantity.over != Quantity::Over::end && quantity.over != Quantity::Over::time_of &&
         !quantity.is(QuantityKind::Of::exact);
}

} // namespace

void Collector::observe_part(const LineState &state) {
  forget_state();
  for (unsigned int i = 0; i < pending.size(); ++i) {
    const Quantity &quantity = model.scene.quantities[i];
    if (quantity.over == Quantity::Over::time_of)
      find_change(quantity, state, false, pending[i]);
    else if (is_followed(quantity))
      follow(quantity, state, pending[i]);
    else if (quantity.time)
      await(quantity, state, false, pending[i]);
  }
  contacts_before.take(model, state);
  previous_time = state.time;
}

void Collector::observe_behind_jump(const LineState &state) {
  forget_state();
  for (History &history : results.histories)
    if (const Motion displacement = builder.motion(state, history.point);
        history.displacement.empty() || displacement != history.displacement.back()) {
      history.time.push_back(state.time);
      history.displacement.push_back(displacement);
    }
  for (unsigned int i = 0; i < pending.size(); ++i)
    if (is_followed(model.scene.quantities[i]))
      follow_back(model.scene.quantities[i], state, pending[i]);
    else if (model.scene.quantities[i].time && !pending[i].value)
      pending[i].previous = evaluate(model.scene.quantities[i], state);
}

void Collector::observe_piece(const MotionPiece &piece) {
  std::vector<unsigned int> followed;
  for (unsigned int i = 0; i < pending.size(); ++i) {
    const Quantity &quantity = model.scene.quantities[i];
    if (is_followed(quantity) && piece.begin < quantity.to && piece.end > quantity.from)
      followed.push_back(i);
  }
  if (followed.empty())
    return;
  Eigen::VectorXd sizes(followed.size());
  for (std::size_t k = 0; k < followed.size(); ++k)
    sizes[k] = pending[followed[k]].largest;
  const SmoothCourses courses(
      [&](const double time) {
        forget_state();
        const LineState &state = piece.state_at(time);
        Eigen::VectorXd values(followed.size());
        for (std::size_t k = 0; k < followed.size(); ++k) // without corners
          values[k] = evaluate_signed(model.scene.quantities[followed[k]], state);
        return values;
      },
      piece.begin, piece.end, sizes,
      [&](const SmoothCourses &so_far) {
        for (std::size_t k = 0; k < followed.size(); ++k) {
          const Quantity &quantity = model.scene.quantities[followed[k]];
          const Pending &course = pending[followed[k]];
          if (quantity.over == Quantity::Over::change || quantity.over == Quantity::Over::rate)
            continue; // asks for the ends
          const double sign = quantity.over == Quantity::Over::maximum ? 1. : -1.;
          const bool is_extreme = sign > 0. || quantity.over == Quantity::Over::minimum;
          if (!is_extreme || quantity.absolute || !course.begun || piece.begin < quantity.from ||
              piece.end > quantity.to || so_far.may_exceed(k, sign, *course.value))
            return false;
        }
        return true;
      });
  forget_state();
  for (std::size_t k = 0; k < followed.size(); ++k)
    follow(followed[k], courses, k, piece);
}

void Collector::follow(const unsigned int i, const SmoothCourses &courses,
                       const unsigned int number, const MotionPiece &piece) {
  using Over = Quantity::Over;
  const Quantity &quantity = model.scene.quantities[i];
  Pending &course = pending[i];
  constexpr double same_number = 1. + 4. * std::numeric_limits<double>::epsilon();
  if (course.begun && piece.begin <= same_number * quantity.from)
    course = {}; // begins behind the jump that there may be
  const double first = std::max(piece.begin, quantity.from),
               last = std::min(piece.end, quantity.to);
  std::vector<double> corners = {first};
  if (quantity.absolute)
    for (const double zero : courses.zeros(number, first, last))
      corners.push_back(zero);
  corners.push_back(last);
  const double scale = quantity.scale < 0. ? -1. : 1.;
  const auto of_size = [&](const double value) {
    return quantity.absolute ? scale * std::abs(value) : value;
  };
  const double at_first = of_size(courses.value(number, first)),
               at_last = of_size(courses.value(number, last));
  course.largest = std::max(course.largest, courses.size(number));
  course.duration += last - first;
  if (!course.begun)
    course.at_start = at_first;
  const bool is_extreme = quantity.over == Over::maximum || quantity.over == Over::minimum;
  const double upwards = quantity.over == Over::maximum ? 1. : -1.;
  if (is_extreme) {
    course.reach(upwards, at_first, first);
    course.reach(upwards, at_last, last);
  }
  for (std::size_t k = 1; k < corners.size(); ++k) { // |what| is smooth in between
    const double from = corners[k - 1], to = corners[k],
                 side = quantity.absolute && courses.value(number, (from + to) / 2.) * scale < 0.
                            ? -1.
                            : 1.;
    if (!is_extreme)
      course.sum += side * courses.integral(number, from, to);
    else if (const auto found =
                 courses.extreme(number, side * upwards, from, to, side * *course.value))
      course.reach(upwards, side * found->value, found->time);
  }
  const double change = at_last - course.at_start;
  if (!is_extreme)
    course.value = quantity.over == Over::integral ? course.sum
                   : quantity.over == Over::change ? change
                   : quantity.over == Over::rate   ? change / course.duration
                                                   : course.sum / course.duration;
  course.begun = true;
  course.previous = at_last;
  course.since = piece.end;
}

void Collector::watch_impacts(const bool transient, const LineState &state) {
  if (transient && contacts_before.status.size() == state.contact_status.size())
    for (const unsigned int i : closed_in(contacts_before, state.events)) {
      if (!is_rigid_stop(model, model.contacts[i]))
        continue;
      for (unsigned int q = 0; q < pending.size(); ++q)
        if (const Quantity &quantity = model.scene.quantities[q];
            state.time >= quantity.from && previous_time <= quantity.to) {
          pending[q].struck =
              pending[q].struck ||
              is_extreme_of_force(quantity, results.supports[results.support_of[i]]);
          pending[q].lacks_impulse =
              pending[q].lacks_impulse ||
              (model.scene.time.is_exact() &&
               is_integral_of_force(quantity, results.supports[results.support_of[i]]));
        }
    }
  contacts_before.take(model, state);
}

} // namespace frictionbeam
