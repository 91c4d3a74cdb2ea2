// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/stress/unintensified_places.h"

#include "base/number_text.h"
#include "scene/in_units.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace frictionbeam {

namespace {

constexpr double straight = 3. * M_PI / 180.; ///< [rad], ASME B31.3, 304.2.3: no miter

/// Directions in which pipe leaves each vertex.
std::vector<std::vector<Vector3>> legs_of(const Scene &scene, const LineMesh &mesh) {
  std::vector<std::vector<Vector3>> legs(mesh.vertices.size());
  for (unsigned int p = 0; p < scene.pipes.size(); ++p) {
    const MeshedPipe &pipe = mesh.pipes[p];
    for (unsigned int i = 0; !scene.pipes[p].rigid && i + 1 < pipe.vertices.size(); ++i) {
      legs[pipe.vertices[i]].push_back(pipe.tangent(mesh.vertices, i, false));
      legs[pipe.vertices[i + 1]].push_back(-pipe.tangent(mesh.vertices, i, true));
    }
  }
  return legs;
}

/// How many of the legs at a vertex are those of a tee's run or of branches with a section Tee.
std::size_t legs_of_tees(const Scene &scene, const LineMesh &mesh, const unsigned int vertex) {
  std::set<std::string> branches;
  for (const Tee &tee : scene.tees)
    if (mesh.points.at(tee.point) == vertex)
      branches.insert(tee.branch);
  std::size_t n = branches.empty() ? 0 : 2;
  for (unsigned int p = 0; p < scene.pipes.size(); ++p)
    if (const auto &at = mesh.pipes[p].vertices; branches.count(scene.pipes[p].name) > 0)
      n += at.front() == vertex || at.back() == vertex ? 1 : 2;
  return n;
}

std::string name_of(const Scene &scene, const LineMesh &mesh, const unsigned int vertex) {
  for (const auto &[name, at] : mesh.points)
    if (at == vertex)
      return name;
  return in_units(scene.units, mesh.vertices[vertex]);
}

} // namespace

std::string unintensified_places(const Scene &scene, const LineMesh &mesh) {
  std::vector<std::string> branches, corners;
  const auto legs = legs_of(scene, mesh);
  for (unsigned int vertex = 0; vertex < legs.size(); ++vertex) {
    const auto &at = legs[vertex];
    const bool is_branch = at.size() > 2,
               is_corner = at.size() == 2 && at[0] * at[1] > -std::cos(straight);
    if ((is_branch || is_corner) && at.size() > legs_of_tees(scene, mesh, vertex))
      (is_branch ? branches : corners).push_back(name_of(scene, mesh, vertex));
  }
  if (branches.empty() && corners.empty())
    return "";
  std::string text = "The stress code has no factors (i = 1) ";
  if (!branches.empty())
    text += "where pipes branch without a section Tee: " + first_of(branches);
  if (!corners.empty())
    text += (branches.empty() ? "" : "; ") + std::string("at corners that are not rounded: ") +
            first_of(corners);
  return text + ". Give a Tee, a bend radius, or look at the stresses there by other means.";
}

} // namespace frictionbeam
