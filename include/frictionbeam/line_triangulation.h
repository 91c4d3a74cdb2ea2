// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/grid/tria.h>

#include <array>

namespace frictionbeam {

/// One cell of a line as its author sees it: two vertices in his own direction, a material id.
struct LineCell {
  std::array<unsigned int, 2> vertices;
  dealii::types::material_id material_id;
};

/// Where a cell of the triangulation comes from.
struct CellOrigin {
  unsigned int index; ///< of the author's cell
  bool reversed;      ///< whether its direction was turned
};

/**
 * Create a triangulation of lines in space from cells in any order and direction, with branches and
 * loops. deal.II 9.4 accepts a vertex of three or more cells only if the first-listed cell there
 * points the other way from the others (an assertion in debug mode); so the cells are listed along
 * a depth-first walk from a free end, each away from it; where a loop closes, cells are turned and
 * listed anew as the rule needs. Walking along the line also keeps the bandwidth small. Where the
 * pipe has supports, the walk is listed backwards but for its first cell: in the author's order,
 * deal.II would take time quadratic in their number.
 *
 * A friction cell between two pipes may be turned like any other. One to a ground vertex of its own
 * keeps the author's direction, from the pipe to the ground, but for some where several supports
 * and a closing loop meet in one vertex: look at CellOrigin::reversed, and see
 * FE_FrictionBeam::Rotations::second_node.
 *
 * @return for each cell of @p triangulation, in the order of its active_cell_iterators(), its
 * origin.
 * @throws dealii::ExcMessage if a cell has length zero, a vertex is in no cell, or loops meet in
 * such a way that there is no order (two rings that have one vertex in common).
 */
std::vector<CellOrigin> create_line_triangulation(const std::vector<dealii::Point<3>> &vertices,
                                                  const std::vector<LineCell> &cells,
                                                  dealii::Triangulation<1, 3> &triangulation);

} // namespace frictionbeam
