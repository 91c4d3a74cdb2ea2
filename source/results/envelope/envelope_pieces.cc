// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/envelope/envelope.h"
#include "results/envelope/envelope_tools.h"

#include "results/envelope/smooth_courses.h"
#include "results/frame/derived_cases.h"
#include "results/support/support_states.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using Instant = SmoothCourses::Instant;

namespace {

/// Part of numbers of a kind by which a course has to exceed what is known: less is rounding, and
/// would move the instant of an extreme that was met before.
constexpr double new_extreme = 1e-12;

constexpr double no_least = -1.; ///< of a size: not asked for

Motion six_from(const Instant &instant, const unsigned int first) {
  Motion values;
  for (unsigned int c = 0; c < 6; ++c)
    values[c] = instant[first + c];
  return values;
}

/// Use a size with both its extremes; at_largest(time) where it becomes larger than it was known.
template <typename Use, typename Size, typename AtLargest>
void use_extremes(const Use &use, const Size &size, Extremes &known, const AtLargest &at_largest) {
  use(size, known.least, known.largest, [&](const double time, const double value) {
    const double largest = known.largest;
    known.include(value, time);
    if (value > largest)
      at_largest(time);
  });
}

/// Of what kind numbers are, so that rounding of one is told by the size of all.
enum NumberKind { force, moment, displacement, rotation, energy };

/// The largest value of a function of instants: that of the courses' points, and beside the largest
/// of them by golden sections.
template <typename Function>
std::pair<double, double> peak_of(const Function &function, const SmoothCourses &courses) {
  constexpr int n_sections = 40;
  constexpr double golden = 0.6180339887498949, beside_end = 1e-6; // of the interval
  const int last = courses.n_points() - 1;
  int best = 0;
  double most = function(Instant(courses, 0));
  for (int i = 1; i <= last; ++i)
    if (const double here = function(Instant(courses, i)); here > most) {
      best = i;
      most = here;
    }
  const auto at = [&](const double t) { return function(Instant(courses, t)); };
  double time = courses.instant(best), low = courses.instant(std::max(best - 1, 0)),
         high = courses.instant(std::min(best + 1, last));
  if ((best == 0 || best == last) &&
      at(time + beside_end * (best == 0 ? high - low : low - high)) <= most)
    return {time, most};
  double t1 = high - golden * (high - low), t2 = low + golden * (high - low), f1 = at(t1),
         f2 = at(t2);
  for (int i = 0; i < n_sections; ++i) {
    const bool first = f1 > f2;
    if (const double here = first ? f1 : f2; here > most) {
      time = first ? t1 : t2;
      most = here;
    }
    (first ? high : low) = first ? t2 : t1;
    const double next = first ? high - golden * (high - low) : low + golden * (high - low);
    (first ? t2 : t1) = first ? t1 : t2;
    (first ? f2 : f1) = first ? f1 : f2;
    (first ? t1 : t2) = next;
    (first ? f1 : f2) = at(next);
  }
  return {time, most};
}

/// A frame whose numbers are those of their kinds.
Frame kinds_of(Frame frame) {
  for (Station &station : frame.line) {
    station.displacement = {displacement, displacement, displacement, rotation, rotation, rotation};
    station.force = {force, force, force, moment, moment, moment};
  }
  for (std::vector<SupportState> *const states : {&frame.supports, &frame.together})
    for (SupportState &support : *states) {
      support.fn = support.ft1 = support.ft2 = force;
      support.gap = support.slip1 = support.slip2 = displacement;
      support.work_friction = energy;
      support.mt = moment;
      support.on_pipe = {force, force, force, moment, moment, moment};
    }
  for (Motion &reaction : frame.reactions)
    reaction = {force, force, force, moment, moment, moment};
  return frame;
}

} // namespace

/// Where numbers of a state stand in the list of all.
struct Envelope::Places {
  explicit Places(const Results &results, const EnvelopeTools &tools)
      : sum_normal(6 * results.supports.size()), restraints(sum_normal + 1),
        points(restraints + 6 * results.restraints.size()), nodes(points + 6 * tools.points.size()),
        stations(nodes + 3 * tools.nodes.size()), frame(stations + 6 * tools.line.size()) {}
  const unsigned int sum_normal, restraints, points, nodes, stations, frame;
};

Eigen::VectorXd Envelope::numbers_at(const LineState &state) {
  const Places places(results, *tools);
  Eigen::VectorXd frame_numbers;
  if (tools->is_part)
    frame_numbers = numbers_of(tools->builder.make(state));
  Eigen::VectorXd result(places.frame + frame_numbers.size());
  result[places.sum_normal] = 0.;
  for (unsigned int i = 0; i < results.supports.size(); ++i) {
    const SupportState now = support_state(model, state, i);
    result.segment<6>(6 * i) << now.fn, now.ft1, now.ft2, now.gap, now.slip1, now.slip2;
    result[places.sum_normal] += std::abs(now.fn);
  }
  unsigned int next = places.restraints;
  for (const Motion &reaction : tools->builder.reactions(state))
    for (const double value : reaction)
      result[next++] = value;
  for (const auto &dofs : tools->points)
    for (const auto dof : dofs)
      result[next++] = EnvelopeTools::value_at(state, dof);
  for (const auto &node : tools->nodes)
    for (unsigned int d = 0; d < 3; ++d)
      result[next++] = EnvelopeTools::value_at(state, node.second[d]);
  tools->section_forces->evaluate(
      state, [](const unsigned int, const SectionForces::Bounds &) { return false; },
      [&](const unsigned int first, const double *const forces, const unsigned int n) {
        std::copy(forces, forces + 6 * n, result.data() + places.stations + 6 * first);
      });
  result.tail(frame_numbers.size()) = frame_numbers;
  return result;
}

Eigen::VectorXd Envelope::kinds_of_numbers(const LineState &state) {
  const Places places(results, *tools);
  Eigen::VectorXd frame_kinds;
  if (tools->is_part)
    frame_kinds = numbers_of(kinds_of(tools->builder.make(state)));
  Eigen::VectorXd result(places.frame + frame_kinds.size());
  for (unsigned int i = 0; i < places.sum_normal; ++i)
    result[i] = i % 6 < 3 ? force : displacement;
  result[places.sum_normal] = force;
  for (unsigned int i = places.restraints; i < places.points; ++i)
    result[i] = (i - places.restraints) % 6 < 3 ? force : moment;
  for (unsigned int i = places.points; i < places.nodes; ++i)
    result[i] = (i - places.points) % 6 < 3 ? displacement : rotation;
  result.segment(places.nodes, places.stations - places.nodes).setConstant(displacement);
  for (unsigned int i = places.stations; i < places.frame; ++i)
    result[i] = (i - places.stations) % 6 < 3 ? force : moment;
  result.tail(frame_kinds.size()) = frame_kinds;
  return result;
}

template <typename Use>
void Envelope::for_each_number(const Use &use) {
  StepEnvelope &envelope = results.envelopes.back();
  const Places places(results, *tools);
  unsigned int next = 0;
  const auto use_extremes = [&](Extremes &known) {
    use(next++, known.least, known.least_at, known.largest, known.largest_at);
  };
  for (SupportEnvelope &support : envelope.supports)
    for (Extremes &known : support.values)
      use_extremes(known);
  use_extremes(envelope.sum_normal);
  for (RestraintEnvelope &restraint : envelope.restraints)
    for (Extremes &known : restraint.values)
      use_extremes(known);
  for (auto &point : envelope.points)
    for (Extremes &known : point)
      use_extremes(known);
  for (unsigned int i = 0; i < envelope.least.size(); ++i)
    use(places.stations + i, envelope.least[i], envelope.least_at[i], envelope.largest[i],
        envelope.largest_at[i]);
  if (!tools->is_part)
    return;
  Eigen::VectorXd least = numbers_of(*envelope.least_frame),
                  largest = numbers_of(*envelope.largest_frame);
  double some_time = 0.; // at whatever instants
  for (Eigen::Index i = 0; i < least.size(); ++i)
    use(places.frame + i, least[i], some_time, largest[i], some_time);
  envelope.least_frame = with_numbers(*envelope.least_frame, least);
  envelope.largest_frame = with_numbers(*envelope.largest_frame, largest);
}

/// A size made of numbers of a state: between which values it is by these courses, and what it is
/// at an instant.
struct Envelope::Size {
  double floor, bound;
  std::function<double(const Instant &)> at;
};

/// Of n numbers of the courses, the norm.
Envelope::Size Envelope::norm_of(const SmoothCourses &courses, const unsigned int first,
                                 const unsigned int n) {
  double floor = 0., bound = 0.;
  for (unsigned int i = first; i < first + n; ++i) {
    floor = std::hypot(floor, courses.floor(i));
    bound = std::hypot(bound, courses.reach(i));
  }
  return Size{floor, bound, [first, n](const Instant &instant) {
                double sum = 0.;
                for (unsigned int i = first; i < first + n; ++i)
                  sum += instant[i] * instant[i];
                return std::sqrt(sum);
              }};
}

template <typename Use>
void Envelope::for_each_size(const MotionPiece &piece, const SmoothCourses &courses,
                             const Use &use) {
  for_each_size_of_supports(piece, courses, use);
  for_each_size_of_restraints(courses, use);
  StepEnvelope &envelope = results.envelopes.back();
  const Places places(results, *tools);
  for (unsigned int i = 0; i < tools->nodes.size(); ++i)
    use(norm_of(courses, places.nodes + 3 * i, 3), no_least, envelope.displacement.largest,
        [&](const double time, const double value) {
          envelope.displacement.include(value, time);
          envelope.displaced_most = tools->nodes[i].first;
        });
  for (unsigned int k = 0; stresses && k < stresses->cases.size(); ++k)
    for (unsigned int i = 0; i < tools->line.size(); ++i) {
      const EnvelopeStresses::Case &one = stresses->cases[k];
      const unsigned int first = places.stations + 6 * i;
      use(Size{0., one.bound(i, [&](const unsigned int c) { return courses.reach(first + c); }),
               [&](const Instant &instant) { return one(i, six_from(instant, first).data()); }},
          no_least, envelope.stresses[k].stress[i], [&](const double time, const double value) {
            envelope.stresses[k].stress[i] = value;
            envelope.stresses[k].time[i] = time;
          });
    }
}

template <typename Use>
void Envelope::for_each_size_of_supports(const MotionPiece &piece, const SmoothCourses &courses,
                                         const Use &use) {
  StepEnvelope &envelope = results.envelopes.back();
  const auto nothing_else = [](const double) {};
  std::vector<Size> frictions;
  double floor = 0., bound = 0.; // of their sum
  for (unsigned int i = 0; i < envelope.supports.size(); ++i) {
    SupportEnvelope &support = envelope.supports[i];
    frictions.push_back(norm_of(courses, 6 * i + 1, 2));
    floor += frictions.back().floor;
    bound += frictions.back().bound;
    use_extremes(use, frictions.back(), support.friction, nothing_else);
    use_extremes(use, norm_of(courses, 6 * i, 3), support.force, [&](const double time) {
      support.at_largest = support_state(model, piece.state_at(time), i);
    });
  }
  const auto sum_of_frictions = [&](const Instant &instant) {
    double sum = 0.;
    for (const Size &friction : frictions)
      sum += friction.at(instant);
    return sum;
  };
  use_extremes(use, Size{floor, bound, sum_of_frictions}, envelope.sum_friction, nothing_else);
}

template <typename Use>
void Envelope::for_each_size_of_restraints(const SmoothCourses &courses, const Use &use) {
  StepEnvelope &envelope = results.envelopes.back();
  const Places places(results, *tools);
  for (unsigned int i = 0; i < envelope.restraints.size(); ++i) {
    const unsigned int first = places.restraints + 6 * i;
    use_extremes(use, norm_of(courses, first, 3), envelope.restraints[i].force,
                 [&](const double time) {
                   envelope.restraints[i].at_largest = six_from(Instant(courses, time), first);
                 });
  }
  for (unsigned int i = 0; i < tools->nozzles.size(); ++i) {
    const NozzleLimit &nozzle = model.scene.nozzles[tools->nozzles[i].first];
    const unsigned int first = places.restraints + 6 * tools->nozzles[i].second;
    Motion reaches;
    for (unsigned int c = 0; c < 6; ++c)
      reaches[c] = courses.reach(first + c);
    use(Size{0., utilization(nozzle, reaches),
             [&](const Instant &instant) { return utilization(nozzle, six_from(instant, first)); }},
        no_least, envelope.nozzles[i].utilization, [&](const double time, const double value) {
          envelope.nozzles[i] = {value, time, six_from(Instant(courses, time), first)};
        });
  }
}

bool Envelope::may_widen(const MotionPiece &piece, const SmoothCourses &courses,
                         const Eigen::VectorXd &sizes) {
  bool result = false;
  for_each_number([&](const unsigned int i, const double least, const double, const double largest,
                      const double) {
    const double margin = new_extreme * sizes[i];
    result = result || courses.may_exceed(i, 1., largest + margin) ||
             courses.may_exceed(i, -1., least - margin);
  });
  if (!result)
    for_each_size(piece, courses,
                  [&](const Size &size, const double least, const double largest, const auto &) {
                    result = result || size.floor < (1. - new_extreme) * least ||
                             size.bound > (1. + new_extreme) * largest;
                  });
  return result;
}

void Envelope::observe_piece(const MotionPiece &piece) {
  if (piece.is_reduced && !needs_line(results.envelopes.back().step))
    return;
  Assert(tools && tools->section_forces, dealii::ExcInternalError());
  results.envelopes.back().is_of_whole_motion = true;
  if (tools->kinds.size() == 0)
    tools->kinds = kinds_of_numbers(piece.state_at(piece.begin));
  Eigen::VectorXd sizes(tools->kinds.size());
  for (Eigen::Index i = 0; i < sizes.size(); ++i)
    sizes[i] = sizes_met[static_cast<unsigned int>(tools->kinds[i])];
  const SmoothCourses courses(
      [&](const double time) { return numbers_at(piece.state_at(time)); }, piece.begin, piece.end,
      sizes, [&](const SmoothCourses &so_far) { return !may_widen(piece, so_far, sizes); });
  for (Eigen::Index i = 0; i < sizes.size(); ++i) {
    double &met = sizes_met[static_cast<unsigned int>(tools->kinds[i])];
    met = std::max(met, courses.size(i));
  }
  for_each_number([&](const unsigned int i, double &least, double &least_at, double &largest,
                      double &largest_at) {
    const auto widen = [&](const double sign, double &known, double &known_at) {
      const double bound = known + sign * new_extreme * sizes[i];
      if (!courses.may_exceed(i, sign, bound))
        return;
      if (const auto found = courses.extreme(i, sign, piece.begin, piece.end, bound)) {
        known = found->value;
        known_at = found->time;
      }
    };
    widen(1., largest, largest_at);
    widen(-1., least, least_at);
  });
  for_each_size(piece, courses,
                [&](const Size &size, const double least, const double largest, const auto &take) {
                  const auto negative = [&size](const Instant &instant) {
                    return -size.at(instant);
                  };
                  if (const double bound = (1. + new_extreme) * largest; size.bound > bound)
                    if (const auto [time, value] = peak_of(size.at, courses); value > bound)
                      take(time, value);
                  if (const double bound = (1. - new_extreme) * least; size.floor < bound)
                    if (const auto [time, value] = peak_of(negative, courses); - value < bound)
                      take(time, -value);
                });
}

} // namespace frictionbeam
