// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/line_mesh.h"

#include <optional>
#include <utility>
#include <vector>

namespace frictionbeam {

/// Unit tangent of a pipe at one of its vertices, in its direction; half way round a plain corner.
Vector3 tangent_of_pipe(const LineMesh &mesh, const MeshedPipe &pipe, const unsigned int place);

/// Pipes that reach a vertex, and its places in their lists, in the order of pipes.
using PlacesInPipes = std::vector<std::pair<unsigned int, unsigned int>>;
PlacesInPipes places_in_pipes(const LineMesh &mesh, const unsigned int vertex);
/// The same of all vertices.
std::vector<PlacesInPipes> places_in_pipes(const LineMesh &mesh);

/**
 * Unit tangent of what runs through a vertex: of its one pipe, of two that go on in each other, and
 * where more meet of the pipe that passes straight through, or else of the two that lie in one
 * line; without the branch of a Tee there. Straight are angles up to ten degrees. The direction is
 * that of the first such pipe. Zero at a free point, nothing where several pipes may be meant.
 */
std::optional<Vector3> tangent_of_run(const Scene &scene, const LineMesh &mesh,
                                      const unsigned int vertex, const PlacesInPipes &places);

} // namespace frictionbeam
