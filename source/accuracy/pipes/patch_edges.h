// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/support_models.h"

namespace frictionbeam::accuracy {

/**
 * Supports that are patches of the pipes' outside, whose edges hold its rotation: a rest stands on
 * both edges of its Width, each with half of what it is, so that it is held by no more than what it
 * carries times Width/2, and an edge may lift off; it is then a pair, whose numbers quantities add
 * up (doc/solid.md, "Growth and edges"). What stands where its edges are not on the same straight
 * run, and the two halves of guides and stops, which press from both sides, have a rotational
 * spring.
 * @param results of the scene, for the supports' places
 */
Scene with_edges(Scene scene, const WallsAtSupports &walls, const Results &results);

} // namespace frictionbeam::accuracy
