// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/reduction/reduced_line.h"

#include "analysis/increment/progress.h"
#include "analysis/march/time_march.h"

namespace frictionbeam {

/// What two runs of a transient step are compared by, at the instants that both have.
struct MotionRecord {
  std::vector<double> time;
  std::vector<Vector> forces;  ///< three of each contact [N]
  std::vector<Vector> motions; ///< six of each monitored point [m, rad]
};

/// How far two runs are apart, relative.
struct MotionDifference {
  double forces = 0.;  ///< root mean square over the step
  double motions = 0.; ///< largest over the step
  double largest() const { return forces > motions ? forces : motions; }
};

/**
 * Distance of two runs, the largest of all components of all contacts and points. Of a contact
 * force, the root mean square over the step of the difference over that of the force itself: a
 * single instant, at which a contact may slip or strike a step sooner, says nothing. Of a motion,
 * the largest difference over the largest value. Both relative to a hundredth of the largest force,
 * displacement or rotation, if that is more.
 */
MotionDifference difference(const MotionRecord &coarse, const MotionRecord &fine);

/**
 * Transient steps on the line reduced to contact nodes and modes (ReducedLine), by the integrators
 * as they are.
 *
 * Modes = auto: the step is run with all modes up to some frequency and again up to twice that
 * frequency, until contact forces and monitored motions no longer change by more than the
 * tolerance. The difference of two runs is that of the coarser one from the truth if the finer one
 * is at least twice as good; the finer one's own error is then estimated by the ratio of the last
 * two differences, and it is the one that is taken (doc/dynamics.md, "How many modes").
 */
class TransientReduction {
public:
  /// @param observer of smooth pieces, of integrators that have them
  TransientReduction(const Model &model, const PieceObserver &observer);

  /// Those who look at the line while it moves.
  struct Observers {
    const Observer &of_instants;
    /// Whether that one looks at more than contacts and monitored points.
    const NeedsLine &needs_line;
    const Pause &pause; ///< between two instants
  };

  /// Decide how many modes the step needs. @return whether it is worth while to reduce it
  bool prepare(const TransientStep &start, const LineState &state, ReductionAccount &account);

  /**
   * Run the step as prepared.
   * @param course of the loads in this step, on the line
   * @param state in: at the start; out: at the end, or the last good one
   * @param resumed to go on within the step at which transfer() has been called
   */
  bool run(const TransientStep &start, const LoadCourse &course, LineState &state,
           StepReport &report, const Observers &observers, const bool resumed);

  /// Whether a step is begun and not at its end.
  bool is_within_step() const { return march != nullptr; }
  /// What the steps to come depend on, and the one at hand.
  /// @param start of the step at hand
  void transfer(const TransientStep &start, Archive &archive);

  const std::string &integrator_name() const { return name; }

private:
  LineParts::Choice choose(const TransientStep &start, const LineState &state,
                           ReductionAccount &account);
  MotionRecord try_out(const TransientStep &start, const LineState &state,
                       const LineParts::Choice &modes, ReductionAccount::Trial &trial) const;
  std::vector<bool> acting(const TransientStep &start) const;
  void begin_march();
  /// The line's state from the reduced one.
  void expand(const LineState &now, const bool everything, LineState &to) const;

  const Model &model;
  const ReductionSettings &settings;
  std::unique_ptr<LineParts> parts;
  const PieceObserver of_pieces;
  std::string name;

  // of the step at hand
  LineParts::Choice choice;
  LineState begun; ///< the line as it began
  std::unique_ptr<ReducedLine> line;
  std::unique_ptr<TimeMarch> march; ///< null before the step begins, and at its end
  LineState reduced, within;
  const LoadCourse *course = nullptr;
  const LineState *whole = nullptr; ///< the line's, as it was last looked at
};

} // namespace frictionbeam
