// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/pipe_junctions.h"

namespace frictionbeam {

/// A part of a straight run or of a bend between two places where its pipe has a vertex, to be cut
/// into cells of one length.
struct RoutePiece {
  const PipePath::Segment *segment;
  double start, end; ///< along the pipe [m]
  int n_cells;
  bool is_arc = false; ///< of a bend, in cells that are arcs

  double length() const { return end - start; }
  bool bends() const { return segment->radius > 0.; }
  /// Along the pipe at the beginning of a cell, or at the end of the last one [m].
  double s(const int cell) const { return start + cell * length() / n_cells; }
};

/**
 * What a mesh of the scene's pipes is to be, whoever makes it: the pipes' axes, where they are
 * joined, and how each is divided. A pipe has a vertex at every corner and end of a bend, where it
 * is joined to others, at repeated supports, named points and hinges.
 */
class RoutePlan {
public:
  /// @throws UserError for routes that are none, pipes that vanish beside others, supports off
  /// their pipe, too many cells
  explicit RoutePlan(const Scene &scene);
  /// Of axes that come from elsewhere than routes, beside Scene::pipes.
  RoutePlan(const Scene &scene, std::vector<PipePath> axes);
  RoutePlan(const RoutePlan &) = delete; // pieces point at segments
  RoutePlan &operator=(const RoutePlan &) = delete;

  unsigned int n_pipes() const { return axes.size(); }
  const PipePath &path(const unsigned int pipe) const { return axes[pipe]; }
  const PipeJunctions &junctions() const { return meetings; }
  /// Of a pipe, one after the other.
  const std::vector<RoutePiece> &pieces(const unsigned int pipe) const { return all[pipe]; }
  /// Two places of a pipe that are nearer to each other are one [m].
  double tolerance() const { return same; }

private:
  const std::vector<PipePath> axes;
  const double same;
  const PipeJunctions meetings;
  std::vector<std::vector<RoutePiece>> all;
};

} // namespace frictionbeam
