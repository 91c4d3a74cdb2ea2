// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/contact_watch.h"
#include "analysis/increment/motion_piece.h"
#include "results/frame/frame_builder.h"

#include <array>
#include <functional>
#include <optional>

namespace frictionbeam {

class SmoothCourses;

/**
 * Gathers results while the analysis runs: frames at the ends of steps and at output instants,
 * histories of monitored points, and the values of the quantities that the scene asks for.
 */
class Collector {
public:
  /// Called with each frame as soon as it is made, so that it can be written.
  using FrameSink = std::function<void(const Frame &)>;

  Collector(const Model &model, Results &results, FrameSink sink);

  /// To be called after every increment of the analysis.
  void observe(const unsigned int step, const unsigned int increment,
               const unsigned int n_increments, const LineState &state);

  /// To be called after every part that an increment is cut into: quantities over time follow it.
  void observe_part(const LineState &state);

  /// To be called with the instant observed last once more, behind a jump: intervals that begin or
  /// go on there begin or go on with this state, and so do histories.
  void observe_behind_jump(const LineState &state);

  /// To be called with every smooth piece of a motion, before its end is observed: extremes and
  /// integrals over time are then exact.
  void observe_piece(const MotionPiece &piece);

  /// Whether observe() will look at more than contacts and the motion of the scene's points.
  bool needs_line(const unsigned int step, const unsigned int increment,
                  const unsigned int n_increments, const double time) const;

  /// To be called for every case made after the load sequence: @p made is put out and kept.
  void observe_case(Frame made);

  /// The quantity in a frame alone, for cases that have no state of the line.
  double evaluate(const Quantity &quantity, const Frame &made) const;

  /// Fill in the quantities' results; those never reached are left out with a remark. If the
  /// analysis stopped between outputs, @p state, the last in equilibrium, is put out as well.
  void finish(const LineState &state);

  /// What was gathered so far.
  void transfer(Archive &archive);

private:
  struct Pending {
    /// Take over a value that is larger, or with @p sign = -1 smaller, and its time if it is by
    /// more than rounding.
    void reach(const double sign, const double reached, const double time);

    std::optional<double> value;
    double previous = 0., since = 0.;   ///< value before, and the time that it belongs to
    double at = 0., value_at = 0.;      ///< when an extreme was reached [s], and what it was then
    double sum = 0., duration = 0.;     ///< integrals over time
    double at_start = 0., largest = 0.; ///< largest: by size
    bool begun = false, struck = false; ///< struck: a rigid support whose force it is an extreme of
    bool lacks_impulse = false;         ///< the same, whose force it is the integral of
    double apart = 0.;                  ///< of a change: the instants that it was found between [s]
  };

  /// Follow a quantity over an interval of time.
  void follow(const Quantity &quantity, const LineState &state, Pending &pending);
  /// The same where a step begins with another state than the one before ended with, as it goes
  /// back to an earlier one or takes initial velocities, or where loads jump: the line jumps, and
  /// that is no motion.
  void follow_back(const Quantity &quantity, const LineState &state, Pending &pending);
  /// The value at the quantity's own time, between the states before and after it.
  void await(const Quantity &quantity, const LineState &state, const bool is_start,
             Pending &pending);
  /// The same from begin to end of a smooth piece.
  void follow(const unsigned int quantity, const SmoothCourses &courses, const unsigned int number,
              const MotionPiece &piece);
  /// @param ends_static whether the state is the end of a static step
  void find_change(const Quantity &quantity, const LineState &state, const bool ends_static,
                   Pending &pending) const;

  /// Note for extremes of forces which rigid supports were struck.
  void watch_impacts(const bool transient, const LineState &state);

  double evaluate(const Quantity &quantity, const LineState &state);
  /// The same, where the absolute value is asked for without that.
  double evaluate_signed(const Quantity &quantity, const LineState &state);
  double section_force(const Quantity &quantity, const Frame &made,
                       const unsigned int component) const;
  double along_direction(const Quantity &quantity, const LineState &state);
  double along_direction(const Quantity &quantity, const Frame &made) const;
  double force_at(const Quantity &quantity, const Frame &made, const unsigned int component) const;
  double of_supports(const Quantity &quantity, const Frame &made) const;
  /// A number of the friction support that a quantity names, summed over the halves of a pair.
  double of_support(const Quantity &quantity,
                    const std::function<double(const unsigned int)> &number) const;
  const Frame &current_frame(const LineState &state);
  /// What is kept of the state at hand: another one comes.
  void forget_state() {
    frame_is_current = false;
    momentum_and_energy.reset();
  }
  void put_out(const LineState &state, const bool keep);
  bool output_is_due(const LoadStep &step, const double time, const bool last) const;

  const Model &model;
  Results &results;
  FrameSink sink;
  FrameBuilder builder;
  std::vector<Pending> pending; ///< beside Scene::quantities
  Frame frame;
  std::optional<std::array<double, 7>> momentum_and_energy; ///< of the state at hand
  bool frame_is_current = false, is_put_out = true;
  unsigned int current_step = 0, current_increment = 0;
  ContactsBefore contacts_before; ///< the increment at hand
  double previous_time = 0., last_output = 0., largest_error = 0.;
};

} // namespace frictionbeam
