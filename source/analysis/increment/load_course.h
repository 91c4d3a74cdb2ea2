// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"
#include "scene/steps/history_origins.h"

#include <array>
#include <functional>

namespace frictionbeam {

/**
 * The loads of one step of the sequence in time: declared factors that go evenly from their values
 * before to those of the step, times each load's own history, and the motion of the ground.
 */
class LoadCourse {
public:
  using Factors = std::vector<double>;
  /// Of instants at which something jumps or bends, which side is meant; both: none.
  enum class Side { before, after, both };

  explicit LoadCourse(const Model &model);

  /// A step of the sequence: declared factors before and at its end, its beginning, and the time in
  /// which they change [s].
  void begin_step(const unsigned int step, const Factors &before, const Factors &after,
                  const double start, const double ramp);

  Factors declared(const double time) const;
  /// The time that laws see: the run's without steps that do not lead to this one [s].
  double time_of_laws(const double time) const { return time - origins.elsewhere; }
  /// With the loads' histories.
  Factors factors(const double time) const;
  /// At the end and the start of a step: where a history jumps, its value before and after.
  Factors factors_at(const double time, const Side side) const;
  Factors factors_before(const double time) const;
  Factors factors_after(const double time) const;
  /// On the unknowns, platens' forces included.
  Vector forces(const double time) const;
  Vector forces(const Factors &factors) const;

  /// Add the inertia and damping of motions that loads impose, by differences in time over the
  /// length of a step, or less where a corner is near. What the velocity jumps at a corner is not
  /// in them (LoadJumps), except with Side::both, whose differences go across.
  void add_inertia(const double time, Vector &forces, const Side side = Side::both) const;
  /// The same derivatives of the factors, of a state at its time.
  void set_rates(LineState &state, const Side side = Side::both) const;
  /// Motions of all degrees of freedom that loads and the ground impose.
  Vector imposed(const double time, const Side side = Side::both) const;
  /// Their derivatives in time on one side of @p time, without jumps, by differences of order 4
  /// over @p span, or less where a corner is near.
  Vector imposed_rates(const double time, const Side side, const double span) const;
  /// Whether there are any.
  bool imposes_motion() const;
  /// What they jump by after @p begin and until @p end; empty if they do not.
  Vector imposed_jumps(const double begin, const double end) const;

  /// The same of the loads' factors.
  Factors factor_jumps(const double begin, const double end) const;
  /// Of factors before and after @p time; 0 where they do not differ but by rounding of what they
  /// are within a time step of it.
  Factors jumps_between(const Factors &before, const Factors &after, const double time) const;

  /// The first instant after @p time at which something may jump or bend; infinity if none.
  double next_break(const double time) const;
  /// Whether there is such an instant from @p start on and before @p end.
  bool may_jump(const double start, const double end) const;
  /// Whether factors of loads and motions of the ground go straight from one instant to another, at
  /// whatever pace, as far as a few instants between them show.
  bool is_straight(const double begin, const double end) const;
  /// Whether forces jump at @p time.
  bool forces_jump(const double time) const;
  /// Whether forces, or velocities of nodes with mass that loads move, jump at @p time.
  bool jumps(const double time) const;

private:
  /// Of the factors, by time; both empty if no load moves what has mass.
  struct Derivatives {
    Factors first, second;
  };
  Derivatives derivatives(const double time, const Side side) const;
  /// Value of a load's history, as the step has it.
  double history_of(const unsigned int load, const double time, const Side side) const;
  /// Value of a history whose time begins at @p origin; both: as at any instant.
  static double value(const TimeFunction &history, const double origin, const double time,
                      const Side side);
  /// The declared factors times the loads' histories.
  double factor(const unsigned int load, const double time, const Side side) const;
  bool is_break(const double time) const;
  /// Instants a time step before and after, the first not before the sequence's step.
  std::array<double, 2> around(const double time) const;
  /// The last instant before @p time at which something may jump or bend; minus infinity if none.
  double last_break(const double time) const;
  /// Call for each history that acts, with the origin of its time.
  void each_history(const std::function<void(const TimeFunction &, const double)> &call) const;

  const Model &model;
  HistoryOrigins origins;
  Factors from, to;
  bool is_static = false; ///< whether loads go to zero from what their histories were at the start
  double start = 0., ramp = 0.; ///< [s]
};

} // namespace frictionbeam
