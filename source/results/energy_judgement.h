// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"

namespace frictionbeam {

/// Share of the turnover that the account may leave over, of a line in small displacements, and in
/// large ones, where it measures the increments.
constexpr double most_energy_left = 0.01, most_energy_left_by_increments = 0.05;

/**
 * Judge the account of energy of every static step, in which nothing may be left over but rounding:
 * above a millionth of the turnover a remark says so, above a hundredth the step has not converged.
 * With large displacements the account measures the increments instead: above a twentieth there is
 * a remark.
 */
void judge_energy(const Scene &scene, Results &results);

/// Say of transient steps whose integrator has gained energy; where nothing moves beyond rounding,
/// nothing is said.
void remark_on_gains(Results &results);

/// Energy that is rounding [J]: the largest force at the end of a step along 1e-12 of the scene's
/// size (of 1 m, where all is at one point).
double energy_of_rounding(const Results &results);

/// What of the account is left over and is more than rounding [J].
double left_over_beyond_rounding(const EnergyAccount &energy);

/// Turnover below which a step's is rounding of the largest step's [J].
double least_turnover(const std::vector<StepReport> &steps);

} // namespace frictionbeam
