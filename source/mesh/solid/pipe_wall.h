// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/body_mesh.h"
#include "mesh/line_mesh.h"
#include "mesh/solid/wall_segment.h"

namespace frictionbeam {

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
  unsigned int vertex = 0;   ///< of the LineMesh, on the axis
  unsigned int support = 0;  ///< in Scene::supports
  unsigned int site = 0;     ///< among the places of that support
  double from = 0., to = 0.; ///< along the chain [m]
  bool is_collar = false;    ///< all round the pipe, of a support that pushes along it
  Vector3 outward;           ///< unit, across the pipe, from its axis to the middle of the patch

  bool covers(const double s) const { return s >= from && s <= to; }
  /// Of the angle between outward and what of the faces of its part belongs to it, for faces that
  /// are cut by its edge are there as a whole.
  double least_cosine() const { return is_collar ? -2. : std::cos(patch_half_arc * (1. + 1e-6)); }
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
  // Of the mesh, whose circle is a polynomial in each cell, so that what is divided by them has
  // the right sum: a part of 5e-5 smaller than a circle's with 16 cells of degree 2.
  double area() const;      ///< of the metal [m2]
  double bore_area() const; ///< [m2]
  double inertia() const;   ///< of the metal, about a diameter [m4]
  unsigned int n_layers() const { return layer_segment.size(); }
  unsigned int layer_of(const unsigned int cell) const { return cell / (around * through); }
  unsigned int pipe_of_layer(const unsigned int layer) const {
    return segments[layer_segment[layer]].pipe;
  }
  /// Of the segments that are there [m].
  double length() const {
    return segments.empty() ? 0. : segments.back().start + segments.back().path.length;
  }
  /// The first segment that ends behind a place along the chain, or the last one.
  const WallSegment &segment_at(const double s) const;
  /// Along the chain [m]. @throws UserError for a vertex that is on no pipe
  double s_of(const LineMesh &line, const unsigned int vertex) const;
  /// The ring at a vertex of the LineMesh. @throws UserError if there is none
  unsigned int ring_at(const unsigned int vertex) const;
};

} // namespace frictionbeam
