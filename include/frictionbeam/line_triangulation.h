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
 * points the other way from all others but the last-listed (an assertion in debug mode); so the
 * cells are listed along a depth-first walk from a free end, each away from it, and those that
 * close loops last, turned as each vertex needs it. Walking along the line also keeps the bandwidth
 * small.
 *
 * @return for each cell of @p triangulation, in the order of its active_cell_iterators(), its
 * origin.
 * @throws dealii::ExcMessage if a cell has length zero, a vertex is in no cell, or there are so
 * many loops that no order is found (cut some of their cells in two).
 */
std::vector<CellOrigin> create_line_triangulation(const std::vector<dealii::Point<3>> &vertices,
                                                  const std::vector<LineCell> &cells,
                                                  dealii::Triangulation<1, 3> &triangulation);

} // namespace frictionbeam
