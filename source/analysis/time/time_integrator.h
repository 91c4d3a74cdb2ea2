// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/equilibrium.h"
#include "analysis/increment/energy_account.h"
#include "analysis/increment/load_course.h"
#include "analysis/increment/motion_piece.h"

namespace frictionbeam {

/// What one time step did.
struct TimeStep {
  EquilibriumResult result;
  double error = 0.;        ///< estimate for the displacements [m]
  bool handed_over = false; ///< a part of it, by an exact integrator to one that is not
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

} // namespace frictionbeam
