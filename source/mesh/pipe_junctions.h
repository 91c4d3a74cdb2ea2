// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/pipe_path.h"

#include <map>

namespace frictionbeam {

/**
 * Where pipes are joined, and where they only lie at the same place.
 *
 * Routes that have a point at the same place are joined there. Where a route has a point and
 * another pipe merely passes, that one is joined too if a pipe ends there (a tee) or if a section
 * Point stands there (a cross), but not if the two overlap on one axis: a nozzle inside a skirt, a
 * pipe in its jacket stay two pipes. A Point that is in no route joins all pipes that it lies on.
 * All else that meets in space, supports repeated to the same place for instance, stays apart. What
 * is not plain from the routes is said in remarks() (doc/theory.md, "Where pipes meet").
 */
class PipeJunctions {
public:
  PipeJunctions(const Scene &scene, const std::vector<PipePath> &paths, const double tolerance);

  /// A place of a pipe that has a number, the same for all pipes that are joined there.
  struct Node {
    double s; ///< along the pipe [m]
    unsigned int number;
  };
  /// Of one pipe, rising in s.
  const std::vector<Node> &nodes(const unsigned int pipe) const { return list[pipe]; }
  /// Number of all nodes.
  unsigned int n_nodes() const { return n; }
  /// The number at @p s of a pipe, if it has one.
  std::optional<unsigned int> node(const unsigned int pipe, const double s) const;

  /// Where a section Point stands: a pipe and its arc length; none if it is on no pipe.
  struct Place {
    unsigned int pipe;
    double s;
  };
  std::optional<Place> place(const std::string &point) const;

  const std::vector<std::string> &remarks() const { return texts; }

private:
  const double tolerance;
  std::vector<std::vector<Node>> list;
  unsigned int n = 0;
  std::map<std::string, Place> places;
  std::vector<std::string> texts;
};

} // namespace frictionbeam
