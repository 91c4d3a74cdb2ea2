// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/line_triangulation.h>

#include <algorithm>
#include <numeric>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Cells at each vertex, row-compressed.
struct Incidence {
  std::vector<unsigned int> start, cell;

  Incidence(const unsigned int n_vertices, const std::vector<LineCell> &cells)
      : start(n_vertices + 1, 0), cell(2 * cells.size()) {
    for (const LineCell &c : cells)
      for (const unsigned int v : c.vertices)
        ++start[v + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<unsigned int> next(start.begin(), start.end() - 1);
    for (unsigned int i = 0; i < cells.size(); ++i)
      for (const unsigned int v : cells[i].vertices)
        cell[next[v]++] = i;
  }

  unsigned int degree(const unsigned int v) const { return start[v + 1] - start[v]; }
};

/// A depth-first walk: tree cells in the order met, then the cells that close loops.
class Walk {
public:
  Walk(const unsigned int n_vertices, const std::vector<LineCell> &cells)
      : cells(cells), incidence(n_vertices, cells), visited(n_vertices, false),
        takes_any(n_vertices, false), n_loops_at(n_vertices, 0), used(cells.size(), false),
        closes_loop(cells.size(), false) {
    for (unsigned int v = 0; v < n_vertices; ++v)
      takes_any[v] = incidence.degree(v) < 3;
    // Free ends first; a part without one (a closed ring) starts at a vertex of two cells.
    for (const unsigned int wanted_degree : {1u, 2u, 0u})
      for (unsigned int v = 0; v < n_vertices; ++v)
        if (!visited[v] && (wanted_degree == 0 || incidence.degree(v) == wanted_degree))
          walk_from(v);
    append_loop_cells();
  }

  std::vector<CellOrigin> order;

private:
  void walk_from(const unsigned int root) {
    AssertThrow(
        incidence.degree(root) > 0,
        ExcMessage("Vertex " + std::to_string(root) +
                   " of the line belongs to no cell. Leave it out of the list of vertices."));
    visited[root] = true;
    std::vector<std::pair<unsigned int, unsigned int>> stack{{root, incidence.start[root]}};
    unsigned int n_children_of_root = 0;
    while (!stack.empty()) {
      const unsigned int vertex = stack.back().first;
      if (stack.back().second == incidence.start[vertex + 1]) {
        stack.pop_back();
        continue;
      }
      const unsigned int c = incidence.cell[stack.back().second++];
      if (used[c])
        continue;
      used[c] = true;
      const unsigned int other = other_end(c, vertex);
      if (visited[other]) {
        closes_loop[c] = true;
        ++n_loops_at[vertex];
        ++n_loops_at[other];
        continue;
      }
      order.push_back({c, cells[c].vertices[0] != vertex});
      visited[other] = true;
      n_children_of_root += vertex == root;
      stack.emplace_back(other, incidence.start[other]);
    }
    AssertThrow(incidence.degree(root) < 3 || n_children_of_root == 1, no_order());
    takes_any[root] = true; // its first cell points away
  }

  /// The first cell of a vertex of three or more points to it, so the cells that close loops are to
  /// point away, but the last: list, again and again, a cell that is the last at one of its ends,
  /// and let it point there.
  void append_loop_cells() {
    std::vector<unsigned int> ready;
    const auto check = [&](const unsigned int v) {
      if (n_loops_at[v] == 1 || (n_loops_at[v] > 1 && takes_any[v]))
        ready.push_back(v);
    };
    // Vertices of three and more that take any are roots, and must take all.
    for (const bool root : {true, false})
      for (unsigned int v = 0; v < visited.size(); ++v)
        if (root == (takes_any[v] && incidence.degree(v) > 2))
          check(v);
    for (unsigned int r = 0; r < ready.size(); ++r)
      for (unsigned int i = incidence.start[ready[r]]; i < incidence.start[ready[r] + 1]; ++i) {
        const unsigned int c = incidence.cell[i], end = ready[r];
        if (!closes_loop[c])
          continue;
        closes_loop[c] = false;
        order.push_back({c, cells[c].vertices[0] == end});
        --n_loops_at[end];
        --n_loops_at[other_end(c, end)];
        check(other_end(c, end));
      }
    AssertThrow(order.size() == cells.size(), no_order());
  }

  unsigned int other_end(const unsigned int c, const unsigned int vertex) const {
    return cells[c].vertices[cells[c].vertices[0] == vertex ? 1 : 0];
  }

  static ExcMessage no_order() {
    return ExcMessage("The loops of the line are so many that deal.II accepts no order of its "
                      "cells. Cut cells between vertices of three and more cells in two.");
  }

  const std::vector<LineCell> &cells;
  const Incidence incidence;
  std::vector<bool> visited;
  std::vector<bool> takes_any; ///< whether further cells may point to the vertex
  std::vector<unsigned int> n_loops_at;
  std::vector<bool> used, closes_loop;
};

} // namespace

std::vector<CellOrigin> create_line_triangulation(const std::vector<Point<3>> &vertices,
                                                  const std::vector<LineCell> &cells,
                                                  Triangulation<1, 3> &triangulation) {
  for (unsigned int i = 0; i < cells.size(); ++i)
    AssertThrow(vertices[cells[i].vertices[0]].distance(vertices[cells[i].vertices[1]]) > 0.,
                ExcMessage("Cell " + std::to_string(i) + " of the line has length zero."));

  const Walk walk(vertices.size(), cells);
  std::vector<CellData<1>> data(cells.size());
  for (unsigned int i = 0; i < data.size(); ++i) {
    const CellOrigin origin = walk.order[i];
    const LineCell &cell = cells[origin.index];
    data[i].vertices = {cell.vertices[origin.reversed ? 1 : 0],
                        cell.vertices[origin.reversed ? 0 : 1]};
    data[i].material_id = cell.material_id;
  }
  triangulation.create_triangulation(vertices, data, SubCellData());
  return walk.order;
}

} // namespace frictionbeam
