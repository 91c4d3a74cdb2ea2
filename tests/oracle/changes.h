// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "random_scene.h"

/**
 * @file
 * Changes of a scene that relations are made of.
 */
namespace oracle {

/// Apply @p Q, a signed permutation of the axes, to everything that has a place or a direction.
/// Supports that are vertical by their kind become ones with a normal.
void turn(Scene &scene, const Eigen::Matrix3d &Q);

/// The same by any rotation: what has components along axes gets axes of its own, springs without
/// damping a full matrix. Free motions, nozzles and spectra keep their axes.
void turn_askew(Scene &scene, const Eigen::Matrix3d &Q);

/// Routes from their ends. @return false where that would not be the same line.
bool reverse_routes(Scene &scene);

/// One pipe becomes two at a place on a straight run. @return false if there is none.
bool cut_a_pipe(Scene &scene, Random &random);

/// A named point on a straight run. @return false if there is none.
bool add_a_point(Scene &scene, const std::string &name, Random &random);

/// Lengths times @p a at equal Young's moduli, densities and stresses: forces grow with the square
/// of a, and what acts on masses is a times smaller.
void scale_lengths(Scene &scene, double a);

/// Rigid rests of one point stand on pieces of pipe that are anchored at both ends instead of the
/// ground. @return false if there are none.
bool stand_on_pipes(Scene &scene);

} // namespace oracle
