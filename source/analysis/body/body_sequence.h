// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/body/continuum_newton.h"
#include "analysis/increment/progress.h"
#include "analysis/increment/step_report.h"

namespace frictionbeam {

/// A body at one instant.
struct ContinuumState {
  unsigned int step = 0, increment = 0;
  double time = 0., factor = 0.;
  std::vector<double> factors;  ///< of the loads; `factor` is the first of them
  ContinuumVector displacement; ///< of all dofs of this process and its neighbours'
  FoundationState contacts;     ///< beside ContinuumBody::nodes
  std::vector<LocalVector> contact_displacement;
};

/// Tractions in global axes on the dofs of contact nodes [N/m2], as yet without those of other
/// processes' nodes.
template <int dim>
ContinuumVector nodal_tractions(const ContinuumBody<dim> &body, const ContinuumState &state);

/// What a pressure adds to a body's stiffness: the forces p S (u - p u_1), of which its own
/// displacement p u_1 is free.
struct Stiffening {
  AssembleMatrices assemble;                                   ///< of S; empty: nothing is added
  std::function<double(const std::vector<double> &)> pressure; ///< p at factors of the loads
  ContinuumVector of_itself;                                   ///< S u_1 on the free dofs
};

/// First guess for a mesh: fields on the dofs, from a coarser one.
struct ContinuumGuess {
  ContinuumVector displacement, traction; ///< traction in global axes at contact nodes
};

/**
 * Runs the declared steps on one mesh: the loads go from factor to factor in equal increments, each
 * cut in two, again and again, where it does not converge.
 */
template <int dim>
class ContinuumSequence {
public:
  ContinuumSequence(const ContinuumBody<dim> &body, const LawLibrary &laws);
  /// Under these loads at factor one, instead of the body's tractions.
  ContinuumSequence(const ContinuumBody<dim> &body, const LawLibrary &laws,
                    std::vector<ContinuumVector> loads, Stiffening stiffening = {});

  /// @param guess used if the whole sequence is one increment; may be null
  /// @param pause called between the increments that the scene declares, and after the last one
  /// @return whether every step converged; if not, ends() closes with the last one in equilibrium
  bool run(const ContinuumGuess *guess, const Pause &pause = {});

  /// Everything of this process that the increments to come depend on, on the same mesh. After
  /// reading, run() goes on from there, and its numbers are those of a run that was never cut.
  void transfer(Archive &archive);

  const std::vector<ContinuumState> &ends() const { return step_ends; } ///< states at ends of steps
  const std::vector<StepReport> &reports() const { return step_reports; }
  const FoundationContacts &contacts() const { return foundation; }
  /// What solves the linear systems, for the summary.
  std::string linear_solver() const { return system->name(); }
  double time() const { return now; } ///< of the last equilibrium, one unit a step

  /// The last state as a guess for a finer mesh, both fields ready to be transferred.
  ContinuumGuess as_guess() const;

private:
  /// How far the sequence is.
  struct Position {
    unsigned int step = 0;
    std::vector<double> from; ///< load factors at the start of the step
    unsigned int next = 0;    ///< increment
    void transfer(Archive &archive) { archive(step, from, next); }
  };

  /// At rest, with the guess if the whole sequence is one increment.
  void start(const ContinuumGuess *guess);
  void start_step();
  using Factors = std::vector<double>;
  bool advance(const Factors &from, const Factors &to, const double start, const double duration,
               const unsigned int halvings);
  bool increment(const Factors &factors, const double time, const double time_increment);
  /// Give the system the stiffness that it has under loads. @return whether that is stable
  bool stiffen(const Factors &factors);
  double stiffening_at(const Factors &factors) const {
    return stiffening.assemble ? stiffening.pressure(factors) : 0.;
  }
  ContinuumVector loads_at(const Factors &factors) const;
  void account(const ContinuumVector &u, const ContinuumVector &loads, const double pressure_rise,
               const FoundationState &contacts);
  void keep(const unsigned int step, const unsigned int increment, const Factors &factors);

  const ContinuumBody<dim> &body;
  const Stiffening stiffening;
  std::unique_ptr<ContinuumSystem> system;
  FoundationContacts foundation;
  ContinuumNewton<dim> newton;
  const std::vector<ContinuumVector> unit_forces; ///< of each load at factor one
  ContinuumVector unknowns;                       ///< zero at held and hanging dofs
  Factors load_factors;
  double now = 0.;
  unsigned int n_reported = 0; ///< factorizations
  FoundationState committed;
  std::vector<ContinuumState> step_ends;
  std::vector<StepReport> step_reports;
  Position position;
  bool is_resumed = false;
};

/// The points of a body's contact nodes, with the diagonal of its stiffness.
template <int dim>
std::vector<FoundationPoint> foundation_points(const ContinuumBody<dim> &body,
                                               const ContinuumSystem &system);

} // namespace frictionbeam
