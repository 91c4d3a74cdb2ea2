// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/cycle_watch.h"
#include "analysis/increment/progress.h"
#include "analysis/increment/step_report.h"
#include "analysis/march/time_march.h"
#include "analysis/sequence/limit_path.h"
#include "analysis/statics/statics.h"

#include <map>
#include <memory>
#include <string>

namespace frictionbeam {

class FollowResolution;
class TransientReduction;

/**
 * Runs the declared sequence of load steps: static increments, each solved by Statics, cut in two,
 * again and again, where they do not converge, and transient steps by TimeMarch, which may run on
 * the line reduced to contact nodes and modes.
 */
class LoadSequence {
public:
  explicit LoadSequence(const Model &model);
  /// @param statics of the model, which keeps its factors for other sequences and must be in the
  /// state in which it was made
  LoadSequence(const Model &model, Statics &statics);
  ~LoadSequence();

  /// @return whether every step converged; if not, state() is the last one in equilibrium.
  /// @param each called with the start and with every increment solved, those of a cut one too;
  /// its number counts these
  bool run(const Observer &observer, const Observer &each = {}, const Pause &pause = {},
           const NeedsLine &needs_line = {});

  /// Have @p observer called with every smooth piece of transient steps, of integrators that have
  /// them (TimeIntegrator::watch()), before the end of the piece is observed. To be called before
  /// transfer() and run().
  void watch(const PieceObserver &observer) {
    Assert(!march, dealii::ExcMessage("The integrator has its observer already."));
    piece_observer = observer;
  }

  /// Leave out of the reports what judges solutions beside their own checks: accounts of energy,
  /// whether states at the ends of steps are the only ones (a factorization a contact), and forces
  /// that nothing determines.
  void leave_out_judgement() { judges = false; }

  /// Everything that the increments to come depend on. After reading, run() goes on from there, and
  /// its numbers are those of a run that was never cut, to the last bit.
  void transfer(Archive &archive);

  const LineState &state() const { return current; }
  /// Of the transient steps, in plain words; empty if there was none.
  std::string integrator_name() const;
  const std::vector<StepReport> &reports() const { return step_reports; }

  /// Factors of the scene's loads at the end of a step that it has reached, with their histories.
  const std::vector<double> &factors_at_end(const unsigned int step) const {
    return factors_at_ends.at(step);
  }

private:
  using Factors = std::vector<double>;
  /// How far the sequence is.
  struct Position {
    unsigned int step = 0;
    Factors from;         ///< at the start of the step
    double start = 0.;    ///< of the step [s]
    std::size_t next = 0; ///< static increment
    void transfer(Archive &archive) { archive(step, from, start, next); }
  };

  void initialize();
  /// What steps to come depend on of those before, but for how far the sequence is.
  void transfer_state(Archive &archive);
  /// Go back to the end of a step; the run's time goes on.
  void go_back_to(const unsigned int step);
  /// Factors of the loads at a step's end, without their histories.
  Factors target_of(const LoadStep &step) const;
  bool run_static(const Factors &target, const Observer &observer);
  /// How much of the present step's way is done, its loads growing evenly.
  double part_done() const;
  /// Whether the present step's limit is on a path that run_to_limit() may follow.
  bool has_path() const;
  /// Follow the path of equilibria to the largest part of the step's loads.
  /// @return whether it is found; of pipes that yield halves of increments may find it yet
  bool run_to_limit(const Observer &observer);
  static constexpr double widest_limit = 1.1; ///< bound over what was carried, to be called so
  /// Of pipes that yield: the least bound of their last motions, by parts of the step's loads.
  std::optional<LimitLoad> bound_of_yield() const;
  /// End the step if pipes that yield carry no more, but for what the bound's proof leaves open.
  bool end_at_collapse();
  /// End it at the present state if its bound is no more than this part of it above.
  bool end_within(const double open);
  /// On the path: declared increments that are done by now, the last of all if the step ends.
  void pass(const std::size_t next, const bool ends, const Observer &observer);
  /// What becomes of an increment along the path.
  enum class OnPath { failed, strayed, passed, accepted };
  OnPath try_on_path(const LimitPath::Trial &trial, const double done);
  /// Whether the loads fall along the path behind a state that is led to, since contacts have
  /// changed theirs on the way: there they were the largest somewhere between.
  bool descends_behind(PathLead lead, const double time, const LineState &to);
  /// Whether the path ends where a contact is about to close: what is carried there is another
  /// branch's, and the step has failed.
  bool is_about_to_meet();
  /// Whether the loads at @p time leave the line unstable if they do not move it.
  bool is_unstable_as_it_stands(const double time) const;
  /// The step ends at the present state, which is its limit.
  void end_at_limit(const std::string &why);
  /// The step has carried all of its loads, and may carry more.
  void end_with_all_loads();
  /// After an increment that has no solution and cannot be made shorter.
  void fail_on_path();
  /// Go to @p end of an increment that the step declares. Histories are followed to their corners,
  /// and on both sides of their jumps.
  bool follow_to(const double end, const bool is_last, const Factors &target);
  /// To the observer, the end of a part of a declared increment.
  void show_part() const;
  bool run_transient(const Factors &target, const Observer &observer);
  bool run_reduced(const Factors &target, const Observer &observer);
  /// Go to the declared factors and time given, in one static increment or in halves of it.
  bool advance(const Factors &from, const Factors &to, const double time,
               const unsigned int halvings);
  /// An increment that takes no time, to what the loads are after a jump.
  bool advance_to_other_side();
  /// Bring the line as it is built into balance with what acts from the start: platens, and
  /// preloads where a limit is sought.
  bool settle();
  bool solve_increment(const Factors &factors, const double time);
  /// Whether a solution of a step that looks for its limit is too far away to be on its path.
  bool jumps(const LineState &to, const double time) const;
  /// Contacts whose slip has turned within the increment that is solved, and whose dynamic friction
  /// is below the static one: they have been at rest in between, where that one holds.
  std::vector<double *> flags_of_turned_slip();
  EquilibriumResult solve_statics(const Factors &full, const double time,
                                  const std::optional<PathLead> &lead, LineState &to);
  /// Make a solution the present state.
  void take(LineState to, const Factors &factors, const double time);
  /// After a static increment: its account of energy, its slips, contacts that it tore off.
  void judge_increment(const LineState &before, EnergyAccount account);
  /// Forces that a state before the first static increment, or the motion before it, leaves
  /// unbalanced; zero if it is in equilibrium.
  Vector unbalanced_at_start() const;
  /// Whether a step that has stopped has done so at the collapse of its pipes.
  void judge_collapse(StepReport &report) const;
  /// Take the present forces into account for force_so_far.
  void measure_forces(const Vector &loads);
  /// Of the sections Initial. @param displaced or velocities only
  void set_initial_motion(const bool displaced);
  /// @throws UserError where a displacement of a section Initial puts a point into a rigid support
  void check_initial_gaps() const;
  /// Where the first step is transient: forces at time 0 of rigid contacts that touch and do not
  /// approach, which press from the first instant and are not struck.
  void press_at_start();
  void commit(const Factors &factors, const double time);

  const Model &model;
  const std::unique_ptr<Statics> own_statics; ///< null if they are another's
  Statics &statics;
  std::unique_ptr<TimeMarch> march; ///< null before the first transient step
  LoadCourse course;
  Factors declared; ///< factors without the loads' histories
  LineState current;
  std::vector<StepReport> step_reports;
  Observer each_increment, part_observer;
  PieceObserver piece_observer;
  Pause between_increments;
  Position position;
  LimitPath path;                           ///< of the step, if it looks for its limit
  std::map<unsigned int, std::string> kept; ///< at the ends of steps that others go back to
  std::vector<Factors> factors_at_ends;     ///< of the loads, with their histories, by step
  bool is_resumed = false, judges = true;
  NeedsLine observer_needs_line;
  std::unique_ptr<TransientReduction> reduction; ///< null before the first step that it is for

  CycleWatch cycles;
  std::unique_ptr<FollowResolution> resolution; ///< null on a reduced line
  double force_so_far = 0.;    ///< largest load or contact force of the sequence [N]
  bool in_equilibrium = false; ///< whether the present state is one of statics
  unsigned int iterations_left = 0, halvings_left = 0; ///< of the declared increment

  // of the increment being solved
  EquilibriumResult last_result;
  bool has_jumped = false; ///< instead of having no solution
  ContactResponse response;
  LoadCourse::Side side = LoadCourse::Side::before; ///< of a jump at the end of an increment
};

} // namespace frictionbeam
