// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/pipe_path.h"

#include <optional>

namespace frictionbeam {

/**
 * The arcs between the nodes of a physical curve that is a bend, as those of a route's bend: of the
 * circle through its first, middle and last node. Nodes between them that miss it by the rounding
 * of their coordinates are moved onto it.
 * @param nodes of the pipe, in its direction
 * @throws UserError for nodes that lie on no circle of the pipe's Bend radius, and for two of them,
 * which have no plane
 */
std::vector<PipePath::Segment> arcs_of_bend(const Scene &scene, const Pipe &pipe,
                                            std::vector<Point3> &nodes);

/// A part of a pipe's nodes that lie on one arc.
struct Arc {
  Point3 begin;
  double radius = 0.; ///< [m]
};
/// The first three cells in a row that are the chords of one arc of at most this radius; empty:
/// none.
std::optional<Arc> arc_among(const std::vector<Point3> &nodes, const double largest_radius);

} // namespace frictionbeam
