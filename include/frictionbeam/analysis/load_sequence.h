// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/equilibrium.h>
#include <frictionbeam/analysis/step_report.h>
#include <frictionbeam/analysis/time_integrator.h>

#include <functional>
#include <limits>

namespace frictionbeam {

class CorotationalStatics;
class FollowResolution;
class TransientReduction;

/**
 * Runs the declared sequence of load steps: static increments, each solved by EquilibriumSolver,
 * and transient time steps of a TimeIntegrator, cut in two, again and again, where they do not
 * converge. Transient steps may run on the line reduced to contact nodes and modes.
 */
class LoadSequence {
public:
  /// Called with the start and then after each increment that the scene declares.
  struct Progress {
    unsigned int step = 0, increment = 0;
    unsigned int n_increments = 0;
  };
  using Observer = std::function<void(const Progress &, const LineState &)>;
  /// Called between two increments, where transfer() may write the sequence.
  using Pause = std::function<void()>;

  /// Whether the observer will look at more of a state than its contacts and the motion of
  /// monitored points: elsewhere, a state of a reduced line may be that of an instant before.
  using NeedsLine = std::function<bool(const Progress &, const double time)>;

  explicit LoadSequence(const Model &model);
  ~LoadSequence();

  /// @return whether every step converged; if not, state() is the last one in equilibrium.
  /// @param each called with the start and with every increment solved, those of a cut one too;
  /// its number counts these
  bool run(const Observer &observer, const Observer &each = {}, const Pause &pause = {},
           const NeedsLine &needs_line = {});

  /// Have @p observer called with every smooth piece of transient steps, of integrators that have
  /// them (TimeIntegrator::watch()), before the end of the piece is observed. To be called before
  /// run().
  void watch(const PieceObserver &observer) { piece_observer = observer; }

  /// Everything that the increments to come depend on. After reading, run() goes on from there, and
  /// its numbers are those of a run that was never cut, to the last bit.
  void transfer(Archive &archive);

  /// Run one transient step of the sequence from a state of this model, as it is.
  /// @param before, target declared factors of the loads before the step and at its end
  bool run_transient_alone(const unsigned int step, const LineState &start,
                           const std::vector<double> &before, const std::vector<double> &target,
                           const Observer &observer);

  const LineState &state() const { return current; }
  /// Of the transient steps, in plain words; empty if there was none.
  std::string integrator_name() const;
  const std::vector<StepReport> &reports() const { return step_reports; }

private:
  using Factors = std::vector<double>;
  /// How far the sequence is.
  struct Position {
    unsigned int step = 0;
    Factors from;               ///< at the start of the step
    double start = 0.;          ///< of the step [s]
    std::size_t next = 0;       ///< static increment, or instant of a transient step
    unsigned int increment = 0; ///< observed so far
    void transfer(Archive &archive) { archive(step, from, start, next, increment); }
  };

  void initialize();
  bool run_static(const Factors &target, const Observer &observer);
  bool run_transient(const Factors &target, const Observer &observer);
  bool run_reduced(const Factors &target, const Observer &observer);
  /// Go to the declared factors and time given, in one static increment or in halves of it.
  bool advance(const Factors &from, const Factors &to, const double time,
               const unsigned int halvings);
  /// An increment that takes no time, to what the loads are after a jump.
  bool advance_to_other_side();
  bool solve_increment(const Factors &factors, const double time);
  bool solve_corotational_increment(const Factors &factors, const double time);
  /// After a static increment: its account of energy, its slips, contacts that it tore off.
  void judge_increment(const LineState &before, EnergyAccount account);
  /// Forces that a state before the first static increment, or the motion before it, leaves
  /// unbalanced; zero if it is in equilibrium.
  Vector unbalanced_at_start() const;
  /// Take the present forces into account for force_so_far.
  void measure_forces(const Vector &loads);
  /// Of the sections Initial. @param displaced or velocities only
  void set_initial_motion(const bool displaced);
  void commit(const Factors &factors, const double time);
  /// Go to @p time in time steps no longer than the one at present, which may change on the way.
  bool move_to(const double time, const std::function<void()> &after_each);
  /// One time step. @return whether it was taken; if not, a shorter one may be.
  bool take_time_step(const double time);

  /// Add what a solve did to the report. @return whether it converged.
  bool report(const EquilibriumResult &result);

  const Model &model;
  const std::unique_ptr<EquilibriumSolver> statics;
  const std::unique_ptr<CorotationalStatics> corotational_statics; ///< null in linear kinematics
  std::unique_ptr<TimeIntegrator> integrator; ///< null before the first transient step
  LoadCourse course;
  Factors declared; ///< factors without the loads' histories
  LineState current;
  std::vector<StepReport> step_reports;
  Observer each_increment;
  PieceObserver piece_observer;
  Pause between_increments;
  Position position;
  bool is_resumed = false;
  NeedsLine observer_needs_line;
  std::unique_ptr<TransientReduction> reduction; ///< null before the first step that it is for

  std::unique_ptr<FollowResolution> resolution; ///< null on a reduced line
  double force_so_far = 0.;    ///< largest load or contact force of the sequence [N]
  bool in_equilibrium = false; ///< whether the present state is one of statics
  unsigned int iterations_left = 0, halvings_left = 0; ///< of the declared increment

  // of the increment being solved
  Vector trial;
  EquilibriumResult last_result;
  ContactResponse response;
  LineState next;
  double time_step = 0., longest_step = 0.;         ///< at present, and never more [s]
  double last_error = 0.;                           ///< of the last time step [m]
  LoadCourse::Side side = LoadCourse::Side::before; ///< of a jump at the end of an increment
  double jump_met = std::numeric_limits<double>::quiet_NaN(); ///< time of the last one looked at
};

} // namespace frictionbeam
