// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/solid_stretches.h"
#include "mesh/tangent_of_run.h"

namespace frictionbeam {

/// Width of a support's patch on a pipe [m]; 0: not given, and the pipe's section has no diameter.
double width_of_patch(const Scene &scene, const FrictionSupport &support, const unsigned int pipe);

/// Whether a line has a support on edges: a solid has the whole patch.
bool stands_on_edges(const Scene &scene, const FrictionSupport &support);

/// Whether a support can stand on edges at all of its places, outside of solid parts.
bool have_edges(const Scene &scene, const LineMesh &mesh, const FrictionSupport &support,
                const std::vector<Site> &sites);

/**
 * The two sites at +-Width/2 along the pipe for each place of a support that stands on edges, each
 * of half of the support (doc/solid.md, "Growth and edges"). A patch that reaches into a solid part
 * is pushed as a whole, and keeps its one site.
 * @throws UserError where the edges are not on one straight run, or the support pushes along it
 */
std::vector<Site> sites_on_edges(const Scene &scene, LineMesh &mesh, const FrictionSupport &support,
                                 const std::vector<Site> &sites);

/// Where a pipe has to have vertices for the edges of patches at these places [m].
std::vector<double> edges_at(const Scene &scene, const FrictionSupport &support,
                             const unsigned int pipe, const std::vector<double> &places,
                             const double length, const std::vector<SolidStretch> &solid);

} // namespace frictionbeam
