// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/analysis/energy_account.h>
#include <frictionbeam/analysis/reduction_account.h>
#include <frictionbeam/analysis/resolution.h>
#include <frictionbeam/analysis/uniqueness.h>

#include <string>

namespace frictionbeam {

/// What the solver did in one step of the load sequence.
struct StepReport {
  std::string step;
  unsigned int increments = 0, halvings = 0, iterations = 0, factorizations = 0;
  std::size_t back_substitutions = 0; ///< with a matrix of the whole line
  double residual = 0.;               ///< largest of its increments, relative to the largest force
  ContactCheck contact;               ///< worst of its increments (exact method)
  EnergyAccount energy;               ///< of static steps
  bool converged = false;
  bool no_equilibrium = false;                      ///< proved that there is none
  std::vector<BeyondUniqueness> several_equilibria; ///< at its end
  std::string remark;                               ///< why it was cut or stopped, in plain words
  std::optional<ReductionAccount> reduction;        ///< of a transient step that might be reduced
  Resolution resolution;                            ///< of the motion by increments and cells
  /// Contacts that a static increment took from sticking, with friction on them, to open.
  std::vector<unsigned int> torn_off;

  void transfer(Archive &archive) {
    archive(step, increments, halvings, iterations, factorizations, back_substitutions, residual,
            contact, energy, converged, no_equilibrium, several_equilibria, remark, reduction,
            resolution, torn_off);
  }
};

} // namespace frictionbeam
