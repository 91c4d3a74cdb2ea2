// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <map>

namespace frictionbeam {

/// One pipe as a chain of vertices in the direction of its route.
struct MeshedPipe {
  std::vector<unsigned int> vertices;
  std::vector<double> s;           ///< arc length at the vertices [m]
  std::vector<double> bend_radius; ///< of each cell between two vertices; 0: straight
  /// Centre of a cell that is an arc as a whole, by the cell's place in the pipe.
  std::map<unsigned int, Point3> arc_centre;
  /// Unit normal of a bend's plane, first tangent x inward, by the cell's place in the pipe.
  std::map<unsigned int, Vector3> bend_axis;

  /// Unit tangent of the pipe at either end of a cell, in its direction.
  Vector3 tangent(const std::vector<Point3> &points, const unsigned int cell,
                  const bool at_end) const;
};

/// Where a part of the scene stands on the mesh.
struct Site {
  unsigned int vertex = 0;
  Vector3 tangent;       ///< of the pipe there, unit; zero at a free point
  double tributary = 1.; ///< length of pipe that falls to it [m], for a bed; otherwise 1
  /// Place of its support, from 0 on, and the vertex of that: two sites have one where it stands on
  /// edges.
  unsigned int place = 0, at = 0;
  Vector3 arm; ///< from there to an edge [m]; otherwise zero
};

/// Of a support.
inline unsigned int n_places(const std::vector<Site> &sites) {
  return sites.empty() ? 0 : sites.back().place + 1;
}

/// The line as gmsh meshed it, with everything the scene places on it found again.
struct LineMesh {
  std::vector<Point3> vertices;
  std::vector<MeshedPipe> pipes;              ///< beside Scene::pipes
  std::map<std::string, unsigned int> points; ///< vertex of each named point
  std::vector<std::vector<Site>> supports;    ///< beside Scene::supports
  std::vector<std::vector<Site>> restraints;  ///< beside Scene::restraints
  std::vector<std::string> remarks;           ///< where pipes were joined, and where not
};

} // namespace frictionbeam
