// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/line_state.h>

#include <functional>

namespace frictionbeam {

/**
 * The loads of one step of the sequence in time: declared factors that go evenly from their values
 * before to those of the step, times each load's own history, and the motion of the ground.
 */
class LoadCourse {
public:
  using Factors = std::vector<double>;

  explicit LoadCourse(const Model &model);

  /// The step: declared factors before and at its end, and the time in which they change [s].
  void begin_step(const Factors &before, const Factors &after, const double start,
                  const double ramp);

  Factors declared(const double time) const;
  /// With the loads' histories.
  Factors factors(const double time) const;
  /// At the end and the start of a step: where a history jumps, its value before and after.
  Factors factors_before(const double time) const;
  Factors factors_after(const double time) const;
  /// On the unknowns, platens' forces included.
  Vector forces(const double time) const;
  Vector forces(const Factors &factors) const;
  /// Add the inertia and damping of motions that loads impose, by differences in time over the
  /// length of a step: the impulse of a velocity that jumps comes out whole over the steps.
  void add_inertia(const double time, Vector &forces) const;
  /// The same derivatives of the factors, of a state at its time.
  void set_rates(LineState &state) const;
  /// Motions of all degrees of freedom that loads and the ground impose.
  Vector imposed(const double time) const;

  /// The first instant after @p time at which something may jump or bend; infinity if none.
  double next_break(const double time) const;
  /// Whether there is such an instant from @p start on and before @p end.
  bool may_jump(const double start, const double end) const;

private:
  /// Of the factors, by time; both empty if no load moves what has mass.
  struct Derivatives {
    Factors first, second;
  };
  Derivatives derivatives(const double time) const;
  /// The declared factors times a value of each load's history.
  Factors declared_times(const double time,
                         const std::function<double(const TimeFunction &)> &value) const;

  const Model &model;
  Factors from, to;
  double start = 0., ramp = 0.;
};

} // namespace frictionbeam
