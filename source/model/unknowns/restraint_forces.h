// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"
#include "scene/scene.h"

#include <functional>

namespace frictionbeam {

/**
 * Forces [N] and moments [N m] of the restraints, in the order of Scene::restraints and their
 * sites, global axes. Those that share a vertex, with the directions h_k that they hold together,
 * have f_k h_k with sum f_k h_k = f,   least sum f_k^2, of what holds the vertex there, f: each its
 * own, and what several of them hold evenly.
 * @param holding f at a vertex
 */
std::vector<Motion> restraint_forces(const Scene &scene, const LineMesh &mesh,
                                     const std::function<Motion(const unsigned int)> &holding);

} // namespace frictionbeam
