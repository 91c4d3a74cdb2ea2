// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/model.h"
#include "results/results.h"

#include <functional>

namespace frictionbeam {

/// Tangent, y and z of the pipe at a station, as it was built.
Axes local_axes_of(const Station &station);

/// Of the pipe that the quantity names, or of the run, as guides and line stops have them.
/// @param frame asked for stations where they are needed
Axes local_axes_of(const Model &model, const Quantity &quantity,
                   const std::function<const Frame &()> &frame);

/// Force and moment in global axes on the face that looks forward along the route [N, N m].
Motion section_force_in_space(const Station &station);

/// A vector's part in the direction of a quantity, which is given in some axes.
double along(const Quantity &quantity, const Axes &axes, const Motion &value);

/// Moments about the normal n of a bend's or tee's plane and about n x t, t the tangent: in the
/// plane and out of it [N m]. n of a bend is its first tangent x inward, of a tee the run's tangent
/// x the branch's.
std::array<double, 2> moments_of_bend(const Vector3 &normal, const Station &station);

/**
 * A quantity of QuantityKind::Of::fibre, of the state of a step.
 * @throws UserError if there is no bend or tee, or the section has no wall
 */
double value_of_fibre(const Model &model, const Quantity &quantity, const Frame &made);

} // namespace frictionbeam
