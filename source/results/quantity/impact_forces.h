// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "results/results.h"
#include "scene/scene.h"

namespace frictionbeam {

/// Whether a quantity is an extreme in time of a force of this support, or of all of them.
bool is_extreme_of_force(const Quantity &quantity, const SupportInfo &support);

/// Whether it is the integral or mean in time of such a force: with an integrator that has impacts
/// between its pieces, and not within steps, without their impulses.
bool is_integral_of_force(const Quantity &quantity, const SupportInfo &support);

/// What the user should know about that, if it was struck.
std::string remark_on_lost_impulse(const Quantity &quantity);

/// The same of a force at a point whose velocity a load changes at an instant, which is an impulse.
/// @return empty if none does, or the quantity is no extreme, integral or mean of such a force
std::string remark_on_velocity_jump(const Quantity &quantity, const Scene &scene,
                                    const std::vector<StepReport> &steps);

/**
 * What the user should know about an extreme of a force of a rigid support that was struck: an
 * impact has an impulse, and its force, infinite for no time, is no number.
 * @throws UserError if the quantity has a reference, which nothing can be compared with
 */
std::string remark_on_impact(const Quantity &quantity);

} // namespace frictionbeam
