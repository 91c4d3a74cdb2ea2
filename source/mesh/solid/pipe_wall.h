// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/body_mesh.h"
#include "mesh/line_mesh.h"
#include "mesh/pipe_path.h"

namespace frictionbeam {

/// A straight run or a bend of a pipe's axis, with axes of the section that go along it without
/// turning about it.
struct WallSegment {
  PipePath::Segment path;
  double start = 0.; ///< along the whole chain of pipes [m]
  unsigned int pipe = 0;
  Vector3 a, b; ///< unit, at the beginning; a x b is the tangent

  /// A direction of the section at the beginning, at @p s from there.
  Vector3 carried(const Vector3 &direction, const double s) const;
};

/// A plane of vertices across the wall.
struct WallRing {
  double s = 0.; ///< along the chain [m]
  unsigned int segment = 0;
  Point3 centre;
  Vector3 tangent, a, b;              ///< unit; angles count from a to b
  std::optional<unsigned int> vertex; ///< of the LineMesh, where a point, support or anchor stands
};

/// Of a patch, from its middle [rad].
constexpr double patch_half_arc = 3.14159265358979323846 / 12.;

/// Where a support's patch is pressed against the outside of the wall.
struct WallPatch {
  std::string part;          ///< of the mesh's boundary
  unsigned int support = 0;  ///< in Scene::supports
  unsigned int site = 0;     ///< among the places of that support
  double from = 0., to = 0.; ///< along the chain [m]
  Vector3 outward;           ///< unit, across the pipe, from its axis to the middle of the patch
};

/**
 * The wall of a chain of pipes in hexahedra that are swept along it: `around` x `through` cells in
 * each layer between two rings, layer by layer, in each from the inside outwards and then around,
 * so that the cell of layer k, j-th from inside and i-th around has the number
 * (k through + j) around + i. Its local directions are: radius, circumference, axis. Faces 0 and 1
 * of a cell look to the bore and to the outside, 4 and 5 lie on the rings before and after.
 */
struct PipeWall {
  double inner = 0., outer = 0.; ///< radii [m]
  unsigned int around = 0, through = 0;
  std::vector<WallSegment> segments;
  std::vector<WallRing> rings;
  std::vector<unsigned int> layer_segment; ///< of the layer between each ring and the next
  std::vector<double> pipe_start;          ///< of each of Scene::pipes along the chain [m]
  std::vector<WallPatch> patches;
  ContinuumMesh<3> mesh; ///< parts `bore`, `begin`, `end`, one for each patch; manifold id: the
                         ///< segment, material id: the pipe

  double mean_radius() const { return 0.5 * (inner + outer); }
  double area() const;      ///< of the metal [m2]
  double bore_area() const; ///< [m2]
  double inertia() const;   ///< of the metal, about a diameter [m4]
  unsigned int n_layers() const { return layer_segment.size(); }
  unsigned int layer_of(const unsigned int cell) const { return cell / (around * through); }
  unsigned int pipe_of_layer(const unsigned int layer) const {
    return segments[layer_segment[layer]].pipe;
  }
  /// The ring at a vertex of the LineMesh. @throws UserError if there is none
  unsigned int ring_at(const unsigned int vertex) const;
};

/**
 * Lay out the wall of a scene's pipes: rings at the ends of bends, at named points, supports and
 * anchors and at the edges of patches, between them bends in equal layers and straight runs in
 * layers that grow away from what disturbs them.
 * @param line the scene's mesh as a line, which knows where supports stand
 * @throws UserError for what is no chain of straight runs and bends of one section, and for patches
 * that leave a straight run or meet
 */
PipeWall build_pipe_wall(const Scene &scene, const LineMesh &line);

} // namespace frictionbeam
