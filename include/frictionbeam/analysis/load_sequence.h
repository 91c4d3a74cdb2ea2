// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/equilibrium.h>
#include <frictionbeam/analysis/step_report.h>

#include <functional>

namespace frictionbeam {

/**
 * Runs the declared sequence of load steps: static increments and transient time steps (Newmark),
 * each solved by EquilibriumSolver and cut in two, again and again, where it does not converge.
 */
class LoadSequence {
public:
  /// Called with the start and then after each increment that the scene declares.
  struct Progress {
    unsigned int step = 0, increment = 0;
    unsigned int n_increments = 0;
  };
  using Observer = std::function<void(const Progress &, const LineState &)>;

  explicit LoadSequence(const Model &model);

  /// @return whether every step converged; if not, state() is the last one in equilibrium.
  /// @param each called with the start and with every increment solved, those of a cut one too;
  /// its number counts these
  bool run(const Observer &observer, const Observer &each = {});

  const LineState &state() const { return current; }
  const std::vector<StepReport> &reports() const { return step_reports; }

private:
  using Factors = std::vector<double>;

  void initialize();
  bool run_static(const unsigned int step, const Factors &target, const Observer &observer);
  bool run_transient(const unsigned int step, const Factors &target, const Observer &observer);
  /// Go to the factors and time given, in one increment or in halves of it.
  bool advance(const Factors &from, const Factors &to, const double time, const bool transient,
               const unsigned int halvings);
  bool solve_increment(const Factors &factors, const double time, const bool transient);
  bool solve_newmark(const EquilibriumProblem &forces, const double time);
  void commit(const Factors &factors, const double time);
  /// Forces of the loads on the unknowns, and the motions they impose.
  EquilibriumProblem problem(const SparseMatrix &matrix, const Factors &factors) const;
  void start_motion();

  /// Add what a solve did to the report. @return whether it converged.
  bool report(const EquilibriumResult &result);

  const Model &model;
  const std::unique_ptr<EquilibriumSolver> statics, dynamics;
  LineState current;
  std::vector<StepReport> step_reports;
  Observer each_increment;

  // of the increment being solved
  Vector trial;
  ContactResponse response;
  SparseMatrix effective;     ///< stiffness + mass/(beta dt^2)
  double effective_step = 0.; ///< dt it was made for; 0: the stiffness
};

} // namespace frictionbeam
