// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/energy_account.h"
#include "analysis/increment/reduction_account.h"
#include "analysis/increment/resolution.h"
#include "model/cell/pipe_sections.h"
#include <frictionbeam/contact/exact_solver.h>

#include <limits>
#include <string>
#include <vector>

namespace frictionbeam {

/// How near a contact came to a change of its state, over one transient step; zero where it
/// changed, infinity where it never could have.
struct ContactMargin {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double slip = none;    ///< of a sticking one, 1 - |T|/(f N)
  double opening = none; ///< of a closed one, its normal force [N]
  double closing = none; ///< of an open one, its gap [m]
};

/// Where a static step ended whose pipes give way.
struct LimitLoad {
  double reached = 0.;   ///< part of the step's loads that is carried, with the equilibrium at hand
  double bound = 0.;     ///< part that no state of stress exceeds; infinite if none is known
  std::string mechanism; ///< where it yields and slips
  void transfer(Archive &archive) { archive(reached, bound, mechanism); }
};

/// What one of several equal cycles of loads did to pipes that yield or creep.
struct CycleVerdict {
  enum class Kind {
    elastic,     ///< nothing ever yielded or crept
    shakedown,   ///< nothing does any more
    alternating, ///< sections yield to and fro, and strains close
    ratchet,     ///< strains grow by the same in each cycle
    unsettled    ///< none of these yet
  };
  Kind kind = Kind::unsettled;
  unsigned int number = 0, of = 0; ///< of the cycle, from 1 on, and how many there are
  double dissipated = 0.;          ///< in it [J]
  double flow = 0.;                ///< by which accumulated plastic and creep strain grew most [-]
  /// Most of a section's strain from its beginning to its end, of those that do not come back [-].
  double growth = 0.;
  double growth_before = 0.; ///< the same of the cycle before
  unsigned int cell = 0;     ///< where that is, or where `flow` is if strains close
  std::string words;
  void transfer(Archive &archive) {
    archive(kind, number, of, dissipated, flow, growth, growth_before, cell, words);
  }
};

/// What the solver did in one step of the load sequence.
struct StepReport {
  std::string step;
  unsigned int increments = 0, halvings = 0, iterations = 0, factorizations = 0;
  std::size_t back_substitutions = 0; ///< with a matrix of the whole line
  double residual = 0.;               ///< largest of its increments, relative to the largest force
  contact::Check contact;             ///< worst of its increments (exact method)
  PipeSections::Check sections;       ///< likewise, of pipes that yield or creep
  EnergyAccount energy;               ///< of static steps
  bool converged = false;
  std::optional<LimitLoad> limit;                            ///< of pipes that yield
  std::optional<CycleVerdict> cycle;                         ///< that ended with it
  bool no_equilibrium = false;                               ///< proved that there is none
  std::vector<contact::BeyondUniqueness> several_equilibria; ///< at its end
  /// Contacts whose shares of force nothing determines at its end; of a transient step, if there
  /// are none, within it, where the first ones had them.
  std::vector<unsigned int> undetermined_forces;
  bool undetermined_within = false;
  std::string remark;                        ///< why it was cut or stopped, in plain words
  std::string warning;                       ///< of its time integrator, to be said once
  std::optional<ReductionAccount> reduction; ///< of a transient step that might be reduced
  std::vector<ContactMargin> margins;        ///< beside the contacts, of a transient step
  /// Rigid contacts that closed in a transient step: an impact, in which their force is infinite
  /// for no time, and only its impulse is a number.
  std::vector<unsigned int> struck;
  Resolution resolution; ///< of the motion by increments and cells
  /// Loads of a transient step that change the velocity of nodes with mass at an instant: an
  /// impulse, which the forces on these nodes leave out.
  std::vector<unsigned int> velocity_jumps;
  /// Contacts that a static increment took from sticking, with friction on them, to open.
  std::vector<unsigned int> torn_off;

  void transfer(Archive &archive) {
    archive(step, increments, halvings, iterations, factorizations, back_substitutions, residual,
            contact, sections.yield_violation, sections.imbalance, sections.unseen_yield, energy,
            converged, limit, cycle, no_equilibrium, several_equilibria, undetermined_forces,
            undetermined_within, remark, warning, reduction, margins, struck, resolution,
            velocity_jumps, torn_off);
  }
};

} // namespace frictionbeam
