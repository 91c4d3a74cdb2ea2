// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "accuracy/support_models.h"

namespace frictionbeam::accuracy {

/**
 * Supports of these walls that can stand on both edges of their Width (FrictionSupport::on_edges,
 * doc/solid.md, "Growth and edges"): rests, where both edges are on one straight run at all places.
 * In Scene::supports.
 */
std::vector<unsigned int> supports_with_edges(const Scene &scene, const WallsAtSupports &walls);

/// Supports of these numbers on edges.
Scene on_edges(Scene scene, const std::vector<unsigned int> &supports);

/**
 * Supports that are patches of the pipes' outside, whose edges hold its rotation: they stand on
 * edges, or have a rotational spring where that is no entry: where both edges are not on the same
 * straight run, and of the two halves of guides and stops, which press from both sides.
 * @param results of the scene, for the supports' places
 */
Scene with_edges(Scene scene, const WallsAtSupports &walls, const Results &results);

} // namespace frictionbeam::accuracy
