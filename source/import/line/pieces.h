// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/line/section_plan.h"
#include "import/pcf/pcf_component.h"

namespace frictionbeam::import {

/// A part of the line between two nodes.
struct Piece {
  std::size_t component = 0; ///< place in PcfLine::components
  unsigned int from = 0, to = 0;
  std::optional<Point3> corner; ///< of a bend, of a rigid part that turns
  double radius = 0.;           ///< of a bend [m]
  bool rigid = false;
  std::size_t section = 0, material = 0;
  std::optional<std::size_t> end_section; ///< of a reducer
  unsigned int run = 0; ///< pieces of one run go through a node together where others meet them
};

/// A branch and the node that it leaves from.
struct BranchFoot {
  unsigned int node = 0, run = 0; ///< run: of the branch
  std::size_t component = 0;
};

/// What stands on the line: a support, a connection, a mass without length.
struct Placed {
  std::size_t component = 0;
  std::optional<unsigned int> node; ///< none: on a bend
  std::size_t piece = 0;            ///< then: the bend
  Point3 position{};                ///< on its arc
  bool in_the_middle = false;       ///< of the bend
};

/// Components as pieces between nodes, ends that are the same within the tolerance made one.
struct Network {
  std::vector<Point3> nodes; ///< multiples of a nanometre, as they will be written
  std::vector<Piece> pieces;
  std::vector<BranchFoot> branches;
  std::vector<Placed> supports, joints, masses;

  /// Pieces at each node.
  std::vector<std::vector<std::size_t>> pieces_at() const;
};

/// A number as it will be written: a multiple of 1e-9 [m].
Point3 on_grid(const Point3 &point);

/**
 * Make pieces of components.
 * @param tolerance within which ends are the same [m]
 * @throws UserError for components of no length, elbows whose centre does not fit, pipes that lie
 *   on each other
 */
Network make_pieces(const PcfFile &file, const PcfLine &line, const double tolerance,
                    SectionPlanner &sections, Notes &notes);

} // namespace frictionbeam::import
