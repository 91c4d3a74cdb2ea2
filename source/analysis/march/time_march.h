// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/contact_watch.h"
#include "analysis/increment/progress.h"
#include "analysis/increment/step_report.h"
#include "analysis/time/time_integrator.h"

#include <limits>

namespace frictionbeam {

class FollowResolution;

/// A transient step of the sequence, as it begins.
struct TransientStep {
  unsigned int step = 0;            ///< place in Scene::steps
  std::vector<double> from, target; ///< declared factors of the loads before it and at its end
  double start = 0.;                ///< [s]
};

/**
 * Takes a line through the transient steps of a sequence with the integrator that Time/Integrator
 * names: time steps that end where loads jump or bend, cut in two, again and again, where they do
 * not converge or their error is above Time/Tolerance, and doubled again behind that.
 */
class TimeMarch {
public:
  /// Those who look at the line while it moves.
  struct Watchers {
    Observer of_instants;                   ///< of output and of quantities
    Observer of_each = {};                  ///< every time step
    Pause pause = {};                       ///< between two instants
    FollowResolution *resolution = nullptr; ///< not of a reduced line
  };

  /// @param observer of smooth pieces, of integrators that have them; called before the end of a
  /// piece is observed
  explicit TimeMarch(const Model &model, const PieceObserver &observer = {});

  /// Go through a step of the sequence.
  /// @param course of the loads in this step
  /// @param state in: at the start; out: at the end, or the last good one
  /// @param resumed to go on within the step at which transfer() has been called
  /// @return whether the end was reached; if not, the report says why
  bool run(const TransientStep &step, const LoadCourse &course, LineState &state,
           StepReport &report, const Watchers &watchers, const bool resumed = false);

  std::string integrator_name() const { return integrator->name(); }
  /// What the time steps to come depend on, besides the line's state.
  void transfer(Archive &archive);

private:
  /// Go to @p time in time steps no longer than the one at present, which may change on the way.
  bool move_to(const double time, const std::function<void()> &after_each);
  /// Rates at which loads move points when the step begins: those with which a transient step
  /// before it ended, 0 out of a static one; empty when the run begins: nothing is known before.
  void set_rates_before();
  /// Whether a time step [s] has been halved as often as it may be.
  bool is_shortest(const double step) const;
  /// Put the state behind a jump of the loads in place of the one before, and show it where
  /// velocities or forces jump.
  void pass_jump(const LoadCourse::Factors factors_before);
  /// One time step. @return whether it was taken; if not, a shorter one may be.
  bool take_time_step(const double time);

  const Model &model;
  const std::unique_ptr<TimeIntegrator> integrator;
  const bool may_share_forces;   ///< contacts at one point, rigid ones of which nothing determines
  std::size_t instant = 0;       ///< that the march goes to, of those of the step
  unsigned int n_increments = 0; ///< of the step so far
  double time_step = 0.;         ///< at present [s]
  double last_error = 0.;        ///< of the last time step [m]
  ContactsBefore contacts_before;

  // of the step at hand
  const LoadCourse *course = nullptr;
  LineState *state = nullptr;
  StepReport *report = nullptr;
  const Watchers *watchers = nullptr;
  unsigned int step_number = 0;
  LineState next;
  double longest_step = 0.;                                   ///< [s]
  double jump_met = std::numeric_limits<double>::quiet_NaN(); ///< time of the last one looked at
};

} // namespace frictionbeam
