// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/step_report.h"
#include "analysis/statics/continuum_newton.h"

namespace frictionbeam {

/// A body at one instant.
struct ContinuumState {
  unsigned int step = 0, increment = 0;
  double time = 0., factor = 0.;
  ContinuumVector displacement; ///< of all dofs of this process and its neighbours'
  FoundationState contacts;     ///< beside ContinuumBody::nodes
  std::vector<LocalVector> contact_displacement;
};

/// First guess for a mesh: fields on the dofs, from a coarser one.
struct ContinuumGuess {
  ContinuumVector displacement, traction; ///< traction in global axes at contact nodes
};

/**
 * Runs the declared steps on one mesh: the tractions go from factor to factor in equal increments,
 * each cut in two, again and again, where it does not converge.
 */
template <int dim>
class ContinuumSequence {
public:
  ContinuumSequence(const ContinuumBody<dim> &body, const LawLibrary &laws);

  /// @param guess used if the whole sequence is one increment; may be null
  /// @return whether every step converged; if not, ends() closes with the last one in equilibrium
  bool run(const ContinuumGuess *guess);

  const std::vector<ContinuumState> &ends() const { return step_ends; } ///< states at ends of steps
  const std::vector<StepReport> &reports() const { return step_reports; }
  const FoundationContacts &contacts() const { return foundation; }
  unsigned int linear_iterations() const { return system->n_linear_iterations; }

  /// The last state as a guess for a finer mesh, both fields ready to be transferred.
  ContinuumGuess as_guess() const;

private:
  bool advance(const double from, const double to, const double start, const double duration,
               const unsigned int halvings);
  bool increment(const double factor, const double time, const double time_increment);
  void account(const ContinuumVector &u, const ContinuumVector &loads,
               const FoundationState &contacts);
  void keep(const unsigned int step, const unsigned int increment, const double factor);

  const ContinuumBody<dim> &body;
  std::unique_ptr<ContinuumSystem> system;
  FoundationContacts foundation;
  ContinuumNewton<dim> newton;
  const ContinuumVector unit_forces; ///< of the tractions at factor one
  ContinuumVector unknowns;          ///< zero at held and hanging dofs
  double load_factor = 0., now = 0.;
  unsigned int n_reported = 0; ///< factorizations
  FoundationState committed;
  std::vector<ContinuumState> step_ends;
  std::vector<StepReport> step_reports;
};

/// The points of a body's contact nodes, with the diagonal of its stiffness.
template <int dim>
std::vector<FoundationPoint> foundation_points(const ContinuumBody<dim> &body,
                                               const ContinuumSystem &system);

} // namespace frictionbeam
