// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/energy_account.h>
#include <frictionbeam/analysis/equilibrium.h>
#include <frictionbeam/analysis/load_course.h>
#include <frictionbeam/analysis/motion_piece.h>

namespace frictionbeam {

/// What one time step did.
struct TimeStep {
  EquilibriumResult result;
  double error = 0.; ///< estimate for the displacements [m]
  EnergyAccount energy;
};

/// A method for the equation of motion M a + C v + K q + contact forces = f.
class TimeIntegrator {
public:
  virtual ~TimeIntegrator() = default;

  /// In plain words, for the report.
  virtual std::string name() const = 0;
  /// Make @p state, given by displacements, velocities and contacts, fit to begin a motion.
  virtual void start(LineState &state, const LoadCourse &loads) = 0;
  /// Go from one state to another at @p time, or as far as it gets (to.time) without changing
  /// direction.
  virtual TimeStep advance(const LineState &from, const LoadCourse &loads, const double time,
                           LineState &to) = 0;
  /// What it keeps between two steps besides the state.
  virtual void transfer(Archive &archive) = 0;
  /// Whether its answers do not depend on the step.
  virtual bool is_exact() const { return false; }
  /// What the user should know about the motion so far; empty if nothing.
  virtual std::string remark() const { return ""; }
  /// What it may do wrong in this model, to be said once; empty if nothing is known.
  virtual std::string warning() const { return ""; }
};

/// The integrator that Time/Integrator names. @param observer of smooth pieces, where it has them
std::unique_ptr<TimeIntegrator> make_time_integrator(const Model &model,
                                                     const PieceObserver &observer = {});

/// Time/Step, or the one that the mesh gives if it is 0 [s].
double time_step(const Model &model);
/// @throws UserError if a transient step takes more time steps than any machine does
void check_time_steps(const Model &model);

/// Unknowns with mass.
std::vector<bool> unknowns_with_mass(const SparseMatrix &mass);

/// The mass matrix, regular: 1 on the diagonal where there is no mass.
SparseMatrix regular_mass(const SparseMatrix &mass);

/// Take over what a solve found out about the contacts.
void commit_contacts(ContactResponse &response, const LineState &before, LineState &after);

/// Wear and impulses of a step with friction elements by their return mapping.
void add_histories(const Contacts &contacts, const LineState &before, LineState &after);

} // namespace frictionbeam
